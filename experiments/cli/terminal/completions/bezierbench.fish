# SPDX-License-Identifier: MIT
# Completion for fish: the program itself lists what can come next; otherwise fish offers files.
function __bezierbench_complete
    set -l words (commandline --current-process --tokenize --cut-at-cursor)
    set -l current (commandline --current-token --cut-at-cursor)
    set -l program (string replace --regex '^~' $HOME -- $words[1])
    set -l found ($program complete $words[2..] "$current" 2>/dev/null)
    if set --query found[1]
        printf '%s\n' $found
    else
        __fish_complete_path (string replace --regex '^--[^=]*=' '' -- "$current")
    end
end
complete --command bezierbench --no-files --arguments '(__bezierbench_complete)'
