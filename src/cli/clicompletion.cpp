#include "cli/clicompletion.h"

#include "cli/clitable.h"

#include <QRegularExpression>

namespace autocuts {

namespace {

using namespace Qt::Literals::StringLiterals;

const QStringList informing{u"--help"_s, u"--version"_s, u"--man-page"_s, u"--markdown"_s, u"--completion"_s};

//! The words that an option takes as its value; empty when it takes others, too.
QStringList wordsOf(const CliOption &option)
{
    static const QRegularExpression words(u"^[a-z0-9-]+(\\|[a-z0-9-]+)+$"_s);
    return words.match(option.value).hasMatch() ? option.value.split(u'|') : QStringList();
}

bool takesPath(const CliOption &option)
{
    return option.value.startsWith(u"FILE"_s) || option.value.startsWith(u"DIR"_s);
}

std::vector<CliOption> optionsOf(const CliCommand &command)
{
    std::vector<CliOption> options;
    std::copy_if(cliOptions().begin(), cliOptions().end(), std::back_inserter(options),
                 [&](const CliOption &option) { return command.takes(option.group); });
    return options;
}

QStringList commandNames()
{
    QStringList names;
    for (const CliCommand &command : cliCommands())
        names << command.name;
    return names;
}

//! The beginning of a meaning, for lists with one line for each option.
QString shortMeaning(const QString &meaning)
{
    constexpr qsizetype longest = 70;
    if (meaning.size() <= longest)
        return meaning;
    return meaning.left(meaning.lastIndexOf(u' ', longest)) + u" ..."_s;
}

//! A word in single quotes, for every shell.
QString quoted(QString text)
{
    return u'\'' + text.replace(u'\'', u"'\\''"_s) + u'\'';
}

QString bashScript()
{
    QString options, values;
    for (const CliCommand &command : cliCommands()) {
        QStringList names;
        for (const CliOption &option : optionsOf(command)) {
            names << option.names;
            const QString pattern = command.name + u':' + option.names.join(u"|"_s + command.name + u':');
            if (const QStringList words = wordsOf(option); !words.isEmpty())
                values += u"        "_s + pattern + u") words="_s + quoted(words.join(u' ')) + u" ;;\n"_s;
            else if (takesPath(option))
                values += u"        "_s + pattern + u") files=1 ;;\n"_s;
            else if (!option.value.isEmpty())
                values += u"        "_s + pattern + u") return ;;\n"_s;
        }
        options += u"        "_s + command.name + u") words="_s + quoted(names.join(u' ')) + u" ;;\n"_s;
    }
    return uR"(# Written by autocuts-cli --completion bash.
_autocuts_cli()
{
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words='' files=''
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W %1 -- "$word")
        return
    fi
    # After "--name=" the equals sign is a word of its own.
    if [[ $before == = ]]; then
        before=${COMP_WORDS[COMP_CWORD-2]}
    elif [[ $word == = ]]; then
        word=''
    fi
    case ${COMP_WORDS[1]}:$before in
        --completion:*) words=%2 ;;
%3    esac
    if [[ -z $words && -z $files && $word == -* ]]; then
        case ${COMP_WORDS[1]} in
%4        esac
    fi
    if [[ -n $words ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    else
        compopt -o filenames
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -F _autocuts_cli autocuts-cli
)"_s.arg(quoted((commandNames() + informing).join(u' ')), quoted(completionShells().join(u' ')), values,
         options);
}

//! Escapes what means something inside of a specification of _arguments.
QString zshText(QString text)
{
    static const QRegularExpression special(u"([\\[\\]:\\\\])"_s);
    return text.replace(special, u"\\\\1"_s);
}

QString zshSpecification(const CliOption &option, const QString &name)
{
    QString text = name;
    if (!option.value.isEmpty() && name.startsWith(u"--"_s))
        text += u'=';
    text += u'[' + zshText(shortMeaning(option.meaning)) + u']';
    if (!option.value.isEmpty()) {
        const QStringList words = wordsOf(option);
        text += u':' + zshText(words.isEmpty() ? option.value : option.names.last().mid(2)) + u':';
        text += words.isEmpty() ? (takesPath(option) ? u"_files"_s : u" "_s) : u'(' + words.join(u' ') + u')';
    }
    return quoted(text);
}

QString zshScript()
{
    QString commands, cases;
    for (const CliCommand &command : cliCommands()) {
        commands +=
            u"        "_s + quoted(command.name + u':' + zshText(shortMeaning(command.meaning))) + u'\n';
        cases += u"    "_s + command.name + u")\n        _arguments"_s;
        for (const CliOption &option : optionsOf(command)) {
            for (const QString &name : option.names)
                cases += u" \\\n            "_s + zshSpecification(option, name);
        }
        cases += u" \\\n            '*:file:_files'\n        ;;\n"_s;
    }
    return uR"(#compdef autocuts-cli
# Written by autocuts-cli --completion zsh.
local -a commands
if ((CURRENT == 2)); then
    commands=(
%1    )
    _describe command commands
    compadd -- %2
    return
fi
local command=$words[2]
shift words
((CURRENT--))
case $command in
    --completion) compadd %3 ;;
%4esac
)"_s.arg(commands, informing.join(u' '), completionShells().join(u' '), cases);
}

QString fishScript()
{
    QString out = u"# Written by autocuts-cli --completion fish.\n"
                  "complete -c autocuts-cli -n __fish_use_subcommand -f\n"_s;
    for (const CliCommand &command : cliCommands())
        out += u"complete -c autocuts-cli -n __fish_use_subcommand -a "_s + command.name + u" -d "_s +
               quoted(shortMeaning(command.meaning)) + u'\n';
    for (const QString &name : informing)
        out += u"complete -c autocuts-cli -n __fish_use_subcommand -l "_s + name.mid(2) + u'\n';
    out += u"complete -c autocuts-cli -n '__fish_seen_argument -l completion' -f -a "_s +
           quoted(completionShells().join(u' ')) + u'\n';
    for (const CliOption &option : cliOptions()) {
        QStringList users;
        for (const CliCommand &command : cliCommands()) {
            if (command.takes(option.group))
                users << command.name;
        }
        out +=
            u"complete -c autocuts-cli -n "_s + quoted(u"__fish_seen_subcommand_from "_s + users.join(u' '));
        for (const QString &name : option.names)
            out += name.startsWith(u"--"_s) ? u" -l "_s + name.mid(2) : u" -s "_s + name.mid(1);
        if (const QStringList words = wordsOf(option); !words.isEmpty())
            out += u" -x -a "_s + quoted(words.join(u' '));
        else if (!option.value.isEmpty())
            out += takesPath(option) ? u" -r"_s : u" -x"_s;
        out += u" -d "_s + quoted(shortMeaning(option.meaning)) + u'\n';
    }
    return out;
}

} // namespace

const QStringList &completionShells()
{
    static const QStringList shells{u"bash"_s, u"zsh"_s, u"fish"_s};
    return shells;
}

QString completionScript(const QString &shell)
{
    if (shell == u"bash")
        return bashScript();
    return shell == u"zsh" ? zshScript() : fishScript();
}

} // namespace autocuts
