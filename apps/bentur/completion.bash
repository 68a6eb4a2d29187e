# Bash completion for bentur. Needs bash alone; example names come from the program itself.

_bentur() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command='' word options
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
      run | gap | modes | check | example) command=$word && break ;;
    esac
  done
  COMPREPLY=()
  if [[ $previous == -o || $previous == --output ]]; then
    mapfile -t COMPREPLY < <(compgen -d -- "$current")
    compopt -o filenames 2>/dev/null
    return
  fi
  if [[ $previous == --method ]]; then
    mapfile -t COMPREPLY < <(compgen -W 'library jacobi' -- "$current")
    return
  fi
  case $command in
    '') options='run gap modes check example --help --version' ;;
    run) options='--output --json --quiet --help' ;;
    gap) options='--json --help' ;;
    modes) options='--json --method --help' ;;
    check) options='--help' ;;
    example) options='--output --help' ;;
  esac
  if [[ -z $command || $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  elif [[ $command == example ]]; then
    local names=''
    while read -r word _; do names+=" $word"; done < <("${COMP_WORDS[0]}" example 2>/dev/null)
    mapfile -t COMPREPLY < <(compgen -W "$names" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -X '!*.toml' -- "$current"; compgen -d -- "$current")
    compopt -o filenames 2>/dev/null
  fi
}
complete -F _bentur bentur
