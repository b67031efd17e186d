// Makes rows of the table of options.
#pragma once

#include "cli/clioption.h"
#include "jobs/settingwords.h"

#include <QRegularExpression>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

//! The field of the options that an option sets.
template <class T>
using Field = std::function<T &(CliOptions &)>;

template <class T>
Field<T> fieldOf(T CliOptions::*member)
{
    return [member](CliOptions &options) -> T & { return options.*member; };
}

template <class T>
Field<T> fieldOf(T SolveSettings::*member)
{
    return [member](CliOptions &options) -> T & { return options.settings.*member; };
}

template <class T>
Field<T> fieldOf(T unwrap::UnwrapOptions::*member)
{
    return [member](CliOptions &options) -> T & { return options.unwrap.*member; };
}

template <class T>
Field<T> fieldOf(T PackingSettings::*member)
{
    return [member](CliOptions &options) -> T & { return options.unwrap.packing.*member; };
}

template <class T>
Field<T> fieldOf(T packing::PackOptions::*member)
{
    return [member](CliOptions &options) -> T & { return options.unwrap.packing.*member; };
}

inline CliOption text(OptionGroup group, const QStringList &names, const Field<QString> &field,
                      const QString &meaning)
{
    return {group,
            names,
            u"FILE"_s,
            meaning,
            {},
            [field](CliOptions &options, const QString &value) -> std::optional<QString> {
                field(options) = value;
                return std::nullopt;
            }};
}

template <class T>
CliOption flag(OptionGroup group, const QString &name, const Field<T> &field, T value, const QString &meaning)
{
    return {group,
            {name},
            {},
            meaning,
            {},
            [field, value](CliOptions &options, const QString &) -> std::optional<QString> {
                field(options) = value;
                return std::nullopt;
            }};
}

//! A numeric option from `low` to `high`. A default outside this range means that the option is off by
//! default, and the texts do not show it.
template <class T>
CliOption number(OptionGroup group, const QString &name, const QString &value, const Field<T> &field,
                 double low, double high, const QString &meaning)
{
    CliOptions defaults;
    const std::optional<double> standard = field(defaults);
    const bool hasStandard = standard && *standard >= low && *standard <= high;
    return {group,
            {name},
            value,
            meaning,
            hasStandard ? QString::number(*standard) : QString(),
            [field, low, high](CliOptions &options, const QString &word) -> std::optional<QString> {
                bool ok = false;
                const double parsed = word.toDouble(&ok);
                if (!ok || !(parsed >= low && parsed <= high))
                    return u"a number from %1 to %2"_s.arg(low).arg(high);
                field(options) = parsed;
                return std::nullopt;
            }};
}

template <class T>
CliOption integer(OptionGroup group, const QString &name, const Field<T> &field, int low, int high,
                  const QString &meaning)
{
    CliOptions defaults;
    return {group,
            {name},
            u"N"_s,
            meaning,
            QString::number(field(defaults)),
            [field, low, high](CliOptions &options, const QString &word) -> std::optional<QString> {
                bool ok = false;
                const int parsed = word.toInt(&ok);
                if (!ok || parsed < low || parsed > high)
                    return u"a whole number from %1 to %2"_s.arg(low).arg(high);
                field(options) = static_cast<T>(parsed);
                return std::nullopt;
            }};
}

template <class T>
CliOption choice(OptionGroup group, const QString &name, const Field<T> &field,
                 const std::vector<std::pair<QString, T>> &words, const QString &meaning)
{
    CliOptions defaults;
    QStringList known;
    QString standard;
    for (const auto &[word, value] : words) {
        known << word;
        if (value == field(defaults))
            standard = word;
    }
    return {group,
            {name},
            known.join(QLatin1Char('|')),
            meaning,
            standard,
            [field, words, known](CliOptions &options, const QString &given) -> std::optional<QString> {
                const auto found = std::find_if(words.begin(), words.end(),
                                                [&](const auto &word) { return word.first == given; });
                if (found == words.end())
                    return known.join(u" or "_s);
                field(options) = found->second;
                return std::nullopt;
            }};
}

//! A choice of a setting that presets name, too.
template <class T>
CliOption choice(OptionGroup group, const QString &name, const Field<T> &field, const QString &meaning)
{
    return choice(group, name, field, jobs::wordsOf<T>(), meaning);
}

inline CliOption defaultingTo(CliOption option, const QString &standard)
{
    option.standard = standard;
    return option;
}

//! An option for a suffix of files.
inline CliOption suffixOption(OptionGroup group, const QString &name, const Field<QString> &field,
                              const QString &meaning)
{
    return {group,
            {name},
            u"SUFFIX"_s,
            meaning,
            {},
            [field](CliOptions &options, const QString &value) -> std::optional<QString> {
                static const QRegularExpression suffix(u"^\\.?([a-z0-9]+)$"_s);
                const auto match = suffix.match(value.toLower());
                if (!match.hasMatch())
                    return u"a suffix such as glb"_s;
                field(options) = match.captured(1);
                return std::nullopt;
            }};
}

} // namespace autocuts
