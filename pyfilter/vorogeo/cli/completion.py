"""The command completion: scripts for shells, made of the tables of options, so that completing starts no Python."""

from __future__ import annotations

from typing import Any

from .options import commands, options_of

_BASH = """\
_vorogeo() {{
  local words=""
  case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{choices}
    *) case "$COMP_CWORD ${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD]}}" in
      "1 "*) words="{commands} --help --version" ;;
{options}
    esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}"))
}}
complete -o default -F _vorogeo vorogeo
"""


def script(shell: str) -> str:
    """The script of bash, zsh or fish; where it offers no word, the shell completes names of files."""
    if shell == "fish":
        return "\n".join(_fish_lines()) + "\n"
    return ("autoload -U +X bashcompinit && bashcompinit\n" if shell == "zsh" else "") + _bash()


def _bash() -> str:
    choices, options = [], []
    for command in commands():
        taken = options_of(command)
        flags = [name for name in taken if name.startswith("-")]
        options.append(f'      *" {command} -"*) words="{" ".join([*flags, "--help"])}" ;;')
        for name, how in taken.items():
            if "choices" in how:
                before = f"{command} {name if name.startswith('-') else command}"
                choices.append(f'    "{before}") words="{" ".join(how["choices"])}" ;;')
    return _BASH.format(choices="\n".join(choices), options="\n".join(options), commands=" ".join(commands()))


def _fish_lines() -> list[str]:
    lines = []
    for command, text in commands().items():
        lines.append(f"complete -c vorogeo -n __fish_use_subcommand -f -a {command} -d {_quoted(text)}")
        for name, how in options_of(command).items():
            if name != "mesh":
                lines.append(
                    f"complete -c vorogeo -n '__fish_seen_subcommand_from {command}' {_fish_option(name, how)}"
                )
    return lines


def _fish_option(name: str, how: dict[str, Any]) -> str:
    words = _quoted(" ".join(how.get("choices", ())))
    if not name.startswith("-"):
        return f"-f -a {words}"
    takes = "" if how.get("action") == "store_true" else f" -x -a {words}" if "choices" in how else " -r"
    return f"-l {name.removeprefix('--')}{takes} -d {_quoted(how['help'])}"


def _quoted(text: str) -> str:
    escaped = text.split(";")[0].rstrip(".").replace("\\", "\\\\").replace("'", "\\'")
    return f"'{escaped}'"
