# Completion of the command displayfile for bash, by bash-completion. What may come next the command
# says itself (programs/manual in its source).

_displayfile() {
  local cur prev words cword line IFS=$' \t\n'
  _init_completion -n =: || return
  local command=${1/#\~\//$HOME/} lines
  mapfile -t lines < <("$command" --complete "${words[@]:1:cword}" 2>/dev/null)

  # The part of the word that readline replaces: it begins anew after = and :.
  local kept=
  [[ $cur == *[=:]* ]] && kept=${cur%"${cur##*[=:]}"}
  [[ $COMP_WORDBREAKS == *[=:]* ]] || kept=
  local whole=$cur
  [[ $cur == --*=* ]] && cur=${cur#*=}

  COMPREPLY=()
  for line in "${lines[@]}"; do
    case $line in
      :files\ ?*)
        local extensions=${line#:files }
        _filedir "@(${extensions// /|})" ;;
      :files*) _filedir ;;
      :folders) _filedir -d ;;
      :more) compopt -o nospace ;;
      *)
        line=${line%%$'\t'*}
        COMPREPLY+=("${line#"$kept"}") ;;
    esac
  done
  cur=$whole
} && complete -F _displayfile displayfile
