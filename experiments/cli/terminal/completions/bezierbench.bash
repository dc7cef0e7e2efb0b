# SPDX-License-Identifier: MIT
# Completion for bash, version 4 or later: the program itself lists what can come next; otherwise bash offers files.
_bezierbench() {
  local line=${COMP_LINE:0:COMP_POINT} word meaning
  local -a words
  read -ra words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  # Bash replaces only what follows the last = or :, which are in $COMP_WORDBREAKS.
  local lead=${words[-1]%"${words[-1]##*[=:]}"}
  COMPREPLY=()
  while IFS=$'\t' read -r word meaning; do
    COMPREPLY+=("${word#"$lead"}")
  done < <("${words[0]/#\~/$HOME}" complete "${words[@]:1}" 2>/dev/null)
  [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
  return 0
}
complete -o bashdefault -o default -F _bezierbench bezierbench
