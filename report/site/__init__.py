# SPDX-License-Identifier: MIT
"""The static site: the documents, a page for each method, the atlas and the playground, made of what is committed. `scripts/site` runs it."""
