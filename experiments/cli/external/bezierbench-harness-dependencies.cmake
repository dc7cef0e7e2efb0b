# SPDX-License-Identifier: MIT
# Packages of which bezierbench::harness links libraries.
find_dependency(Threads)
find_dependency(TBB)
find_dependency(fmt)
find_dependency(OpenSSL COMPONENTS Crypto)
find_dependency(benchmark)
find_dependency(tomlplusplus)
find_dependency(pugixml)
find_dependency(Freetype)
