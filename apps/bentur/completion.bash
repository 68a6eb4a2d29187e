# Bash completion for bentur. Needs bash alone; example names come from the program itself.

_bentur() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command='' word options
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
      run | report | gap | sweep | ida | fragility | risk | remedy | sensitivity | modes | check | spectrum | plot | example | import | schema) command=$word && break ;;
    esac
  done
  COMPREPLY=()
  if [[ $previous == --hazard ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
    compopt -o filenames 2>/dev/null
    return
  fi
  if [[ $previous == -o || $previous == --output ]]; then
    mapfile -t COMPREPLY < <(compgen "$([[ $command == @(sweep|ida|remedy|sensitivity|spectrum|plot|report|import|schema) ]] && echo -f || echo -d)" -- "$current")
    compopt -o filenames 2>/dev/null
    return
  fi
  if [[ $previous == --method ]]; then
    mapfile -t COMPREPLY < <(compgen -W 'library jacobi' -- "$current")
    return
  fi
  if [[ $previous == --figures ]]; then
    mapfile -t COMPREPLY < <(compgen -W 'svg pdf png svg,pdf' -- "$current")
    return
  fi
  if [[ $previous == --lang ]]; then
    mapfile -t COMPREPLY < <(compgen -W 'en id' -- "$current")
    return
  fi
  case $command in
    '') options='run report gap sweep ida fragility risk remedy sensitivity modes check spectrum plot example import schema --help --version' ;;
    run) options='--output --figures --lang --json --quiet --force --help' ;;
    report) options='--output --lang --hazard --site --force --help' ;;
    gap) options='--at --lang --json --help' ;;
    sweep | ida) options='--output --resume --check --threads --quiet --force --help' ;;
    fragility) options='--event --at --probability --along --resamples --confidence --seed --json --help' ;;
    risk) options='--hazard --unit --site --event --method --years --target --resamples --confidence --seed --lang --json --help' ;;
    remedy) options='--output --figure --resume --json --lang --force --help' ;;
    sensitivity) options='--by --output --json --lang --force --help' ;;
    modes) options='--json --method --help' ;;
    check) options='--lang --help' ;;
    spectrum) options='--unit --format --time-step --column --channel --skip-lines --damping --periods --length --output --lang --force --json --help' ;;
    plot) options='--output --force --list --from --to --gap --elevation --at --against --event --width --lang --help' ;;
    example) options='--output --no-schema --force --help' ;;
    import) options='--along --at --section --around --radius --without --parts --levels --snap --hull --metres --clearance --storeys --storey-height --floor-mass --period-formula --output --force --help' ;;
    schema) options='--output --force --help' ;;
  esac
  if [[ -z $command || $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  elif [[ $command == spectrum || $command == fragility || $command == risk || $command == import ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
    compopt -o filenames 2>/dev/null
  elif [[ $command == plot && $previous == *.nc ]]; then
    local kinds=''
    while read -r word _; do kinds+=" $word"; done < <("${COMP_WORDS[0]}" plot "$previous" --list 2>/dev/null)
    mapfile -t COMPREPLY < <(compgen -W "$kinds" -- "$current")
  elif [[ $command == plot ]]; then
    mapfile -t COMPREPLY < <(compgen -f -X '!*.nc' -- "$current"; compgen -d -- "$current")
    compopt -o filenames 2>/dev/null
  elif [[ $command == schema ]]; then
    mapfile -t COMPREPLY < <(compgen -W 'case study' -- "$current")
  elif [[ $command == example ]]; then
    local names=''
    while read -r word _; do names+=" $word"; done < <("${COMP_WORDS[0]}" example 2>/dev/null)
    mapfile -t COMPREPLY < <(compgen -W "$names" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -X '!*.toml' -- "$current"; compgen -d -- "$current"
      [[ $command != report ]] || compgen -f -X '!*.nc' -- "$current")
    compopt -o filenames 2>/dev/null
  fi
}
complete -F _bentur bentur
