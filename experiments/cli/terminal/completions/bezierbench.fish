# SPDX-License-Identifier: MIT
# Completion for fish: the program itself knows what may come next.
function __bezierbench_complete
    set -l words (commandline --current-process --tokenize --cut-at-cursor)
    set -l current (commandline --current-token --cut-at-cursor)
    set -l program (string replace --regex '^~' $HOME -- $words[1])
    for line in ($program complete $words[2..] "$current" 2>/dev/null)
        switch $line
            case :files
                __fish_complete_path (string replace --regex '^--[^=]*=' '' -- "$current")
            case :folders
                __fish_complete_directories (string replace --regex '^--[^=]*=' '' -- "$current") ''
            case '*'
                echo $line
        end
    end
end
complete --command bezierbench --no-files --arguments '(__bezierbench_complete)'
