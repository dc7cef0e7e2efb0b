# SPDX-License-Identifier: MIT
# Completion for bash, version 4 or later: the program itself knows what may come next.
_bezierbench() {
  local line=${COMP_LINE:0:COMP_POINT} word help name
  local -a words names
  read -ra words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  local current=${words[-1]}
  # Bash replaces only what follows the last = or :, which are in $COMP_WORDBREAKS.
  local lead=${current%"${current##*[=:]}"}
  local path=$current
  [[ $current == --*=* ]] && path=${current#*=}
  COMPREPLY=()
  while IFS=$'\t' read -r word help; do
    case $word in
      :files) mapfile -t names < <(compgen -f -- "$path") ;;
      :folders) mapfile -t names < <(compgen -d -- "$path") ;;
      *)
        COMPREPLY+=("${word#"$lead"}")
        continue
        ;;
    esac
    compopt -o filenames 2>/dev/null
    for name in "${names[@]}"; do COMPREPLY+=("${name#"${path%"${path##*[=:]}"}"}"); done
  done < <("${words[0]/#\~/$HOME}" complete "${words[@]:1}" 2>/dev/null)
  [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
  return 0
}
complete -F _bezierbench bezierbench
