# Completion of the command displayfile for fish. What may come next the command says itself
# (programs/manual in its source).

function __displayfile_completions
    set -l typed (commandline -ct)
    set -l words (commandline -opc) "$typed"
    # A file's name begins after the = of --option=FILE.
    set -l before (string match -r -- '^--[^=]*=' "$typed")
    set -l rest (string replace -r -- '^--[^=]*=' '' "$typed")
    type -q -- $words[1]; or return
    for line in ($words[1] --complete $words[2..-1] 2>/dev/null)
        switch $line
            case ':files*'
                set -l endings (string split -n ' ' -- (string replace ':files' '' -- $line))
                for file in (complete -C "'' $rest" | string replace -r '\t.*' '')
                    set -l ending (string lower -- (string replace -r '.*\.' '' -- $file))
                    if test -z "$endings"
                        or string match -q -r '/$' -- $file
                        or contains -- "$ending" $endings
                        echo "$before$file"
                    end
                end
            case ':folders'
                printf '%s\n' "$before"(__fish_complete_directories "$rest" '' | string replace -r '\t.*' '')
            case ':more'
            case '*'
                echo $line
        end
    end
end

complete -c displayfile -f -a '(__displayfile_completions)'
