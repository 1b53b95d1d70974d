# Completion for bash. What can be said is read off the program's own help, so that it is always that of this version.

_rtlang() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local commands command=render words=
  commands=$("$program" --help 2>/dev/null | sed -n '/^Commands/,/^$/s/^  \([a-z]\{1,\}\).*/\1/p')
  if ((COMP_CWORD > 1)) && [[ " ${commands//$'\n'/ } " == *" ${COMP_WORDS[1]} "* ]]; then
    command=${COMP_WORDS[1]}
  fi

  case $previous in
    --diagnostics) words='text json' ;;
    --format) words='png exr ppm pfm' ;;
    --bits) words='8 16' ;;
    --stats) words='json' ;;
    --mode) words='whitted path occlusion' ;;
    --allow) words=$("$program" lint --rules 2>/dev/null | sed 's/^[^ ]* *\([a-z_]*\) .*/\1/') ;;
    -D | --size | --samples | --max-* | --crop | --threads | --time | --part | --pixel | --sample | --ray | --at | --depth | --least | --gate | --depth-share | --scenes | --seed | --noise | --min-weight) return ;;
  esac
  if [[ $word == -* ]]; then
    words=$("$program" "$command" --help 2>/dev/null | sed -n 's/^ *\(-[A-Za-z]\), \(--[a-z-]*\).*/\1 \2/p; t; s/^ *\(--*[A-Za-z-]*\) .*/\1/p')
  elif [[ $command == explain ]]; then
    words=$("$program" explain 2>/dev/null | sed 's/ .*//')
  elif [[ $command == doc ]]; then
    words=$("$program" doc --names 2>/dev/null)
  elif ((COMP_CWORD == 1)); then
    words=$commands
  fi

  local IFS=$' \t\n'
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  [[ $word == -* || $command == explain || $command == doc ]] && return
  compopt -o filenames 2>/dev/null
  IFS=$'\n'
  case $previous in
    -o | --output | --report) COMPREPLY+=($(compgen -f -- "$word")) ;;
    --include-root) COMPREPLY+=($(compgen -d -- "$word")) ;;
    --diagnostics | --format | --bits | --mode | --allow) ;;
    *) COMPREPLY+=($(compgen -f -- "$word" | grep -E '\.(rtl|rt|png|exr|ppm|pgm|pfm)$') $(compgen -d -- "$word")) ;;
  esac
}

complete -F _rtlang rtlang
