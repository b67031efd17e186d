#include "jobs/mapsettings.h"

#include "jobs/jobtexts.h"
#include "jobs/settingwords.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

namespace {

//! A setting and its name.
struct NamedSetting
{
    QString name;
    bool hasValue = true;
    //! Returns a description of valid values when the value is invalid.
    std::function<std::optional<QString>(MapSettings &, const QString &value)> read;
    //! The value; nothing where no line says it: a switch that is off.
    std::function<std::optional<QString>(const MapSettings &)> write;
};

// Where a setting is.
template <class T>
auto fieldOf(T SolveSettings::*member)
{
    return [member](auto &settings) -> auto &
    {
        return settings.solve.*member;
    };
}
template <class T>
auto fieldOf(T PackingSettings::*member)
{
    return [member](auto &settings) -> auto &
    {
        return settings.packing.*member;
    };
}

template <class Field>
NamedSetting choice(const QString &name, Field field)
{
    using T = std::decay_t<decltype(field(std::declval<MapSettings &>()))>;
    return {name, true,
            [field](MapSettings &settings, const QString &value) -> std::optional<QString> {
                QStringList known;
                for (const auto &[word, choice] : wordsOf<T>()) {
                    known << word;
                    if (word == value) {
                        field(settings) = choice;
                        return std::nullopt;
                    }
                }
                return known.join(u" or "_s);
            },
            [field](const MapSettings &settings) -> std::optional<QString> {
                const auto &words = wordsOf<T>();
                return std::find_if(words.begin(), words.end(),
                                    [&](const auto &word) { return word.second == field(settings); })
                    ->first;
            }};
}

template <class Field>
NamedSetting number(const QString &name, Field field, double low, double high)
{
    return {name, true,
            [field, low, high](MapSettings &settings, const QString &value) -> std::optional<QString> {
                using T = std::decay_t<decltype(field(settings))>;
                bool ok = false;
                const double read = std::is_integral_v<T> ? value.toInt(&ok) : value.toDouble(&ok);
                if (!ok || !(read >= low && read <= high))
                    return JobTexts::tr("a number from %1 to %2")
                        .arg(QString::number(static_cast<T>(low)), QString::number(static_cast<T>(high)));
                field(settings) = static_cast<T>(read);
                return std::nullopt;
            },
            [field, low](const MapSettings &settings) -> std::optional<QString> {
                const auto value = field(settings);
                if (value < low) // the default of what is chosen by itself
                    return std::nullopt;
                if constexpr (std::is_integral_v<std::decay_t<decltype(value)>>)
                    return QString::number(value);
                else
                    return QString::number(value, 'g', QLocale::FloatingPointShortest);
            }};
}

//! One value of a setting, by a name without a value.
template <class Field, class T = bool>
NamedSetting named(const QString &name, Field field, T value = true)
{
    return {name, false,
            [field, value](MapSettings &settings, const QString &) -> std::optional<QString> {
                field(settings) = value;
                return std::nullopt;
            },
            [field, value](const MapSettings &settings) {
                return field(settings) == value ? std::optional(QString()) : std::nullopt;
            }};
}

const std::vector<NamedSetting> &namedSettings()
{
    static const std::vector<NamedSetting> settings{
        choice(
            u"quality"_s, [](auto &all) -> auto & { return all.quality; }),
        number(u"max-distortion"_s, fieldOf(&SolveSettings::maxDistortion), 4.0001, SolveSettings::maxBound),
        choice(u"seams"_s, fieldOf(&SolveSettings::seams)),
        {u"seams-from"_s, true,
         [](MapSettings &all, const QString &value) { return readSeamSources(all.solve.givenSeams, value); },
         [](const MapSettings &all) { return std::optional(seamSourcesText(all.solve.givenSeams)); }},
        choice(u"init"_s, fieldOf(&SolveSettings::start)),
        choice(u"weights"_s, fieldOf(&SolveSettings::weighting)),
        choice(u"energy"_s, fieldOf(&SolveSettings::energy)),
        choice(u"solver"_s, fieldOf(&SolveSettings::solver)),
        choice(u"for"_s, fieldOf(&SolveSettings::surface)),
        choice(u"flat"_s, fieldOf(&SolveSettings::flat)),
        choice(u"alike"_s, fieldOf(&SolveSettings::alike)),
        choice(u"creases"_s, fieldOf(&SolveSettings::creases)),
        number(u"crease-strength"_s, fieldOf(&SolveSettings::creaseStrength), 0, 1),
        number(u"visibility"_s, fieldOf(&SolveSettings::visibility), 0, 1),
        named(u"symmetry"_s, fieldOf(&SolveSettings::symmetry), SymmetryMode::On),
        named(u"no-symmetry"_s, fieldOf(&SolveSettings::symmetry), SymmetryMode::Off),
        choice(u"align"_s, fieldOf(&SolveSettings::align)),
        named(u"mirror"_s, fieldOf(&SolveSettings::mirrorMaps)),
        choice(u"world-up"_s, fieldOf(&SolveSettings::worldUp)),
        number(u"seed"_s, fieldOf(&SolveSettings::seed), 0, std::numeric_limits<int>::max()),
        {u"texture-size"_s, true,
         [](MapSettings &all, const QString &value) { return readTextureSize(all.packing, value); },
         [](const MapSettings &all) { return std::optional(textureSizeText(all.packing)); }},
        number(u"margin"_s, fieldOf(&PackingSettings::margin), 0, 4096),
        number(u"tile-border"_s, fieldOf(&PackingSettings::border), 0, 4096),
        choice(u"rotation"_s, fieldOf(&PackingSettings::rotation)),
        number(u"tile"_s, fieldOf(&PackingSettings::udimTile), PackingSettings::firstTile,
               PackingSettings::lastTile),
        number(u"pack-time"_s, fieldOf(&PackingSettings::effort), 0, PackingSettings::maxEffort),
        named(u"keep-scale"_s, fieldOf(&PackingSettings::keepScale)),
    };
    return settings;
}

//! What is wrong with a line, or nothing.
std::optional<QString> read(const NamedSetting &setting, const QString &value, MapSettings &settings)
{
    if (setting.hasValue == value.isEmpty())
        return (setting.hasValue ? JobTexts::tr("%1 needs a value") : JobTexts::tr("%1 takes no value"))
            .arg(setting.name);
    const std::optional<QString> expected = setting.read(settings, value);
    if (!expected)
        return std::nullopt;
    return JobTexts::tr("%1 takes %2, not \"%3\"").arg(setting.name, *expected, value);
}

} // namespace

Result<PresetSettings> settingsOf(const Preset &preset, const MapSettings &before)
{
    PresetSettings made;
    made.settings.solve.lambda = before.solve.lambda;
    made.settings.solve.delta = before.solve.delta;
    made.settings.solve.boxWeight = before.solve.boxWeight;
    for (const PresetOption &option : preset.options) {
        const auto setting =
            std::find_if(namedSettings().begin(), namedSettings().end(),
                         [&](const NamedSetting &one) { return u"--"_s + one.name == option.name; });
        if (setting == namedSettings().end())
            made.others << option.name.mid(2);
        else if (const auto problem = read(*setting, option.value, made.settings))
            return Error{*problem, preset.path, option.line,
                         JobTexts::tr("Correct the line, or save the preset again")};
    }
    made.settings.packing.margin = std::round(made.settings.packing.margin); // as sessions keep it
    if (!made.settings.packing.isValid())
        return Error{JobTexts::tr("the margin or the border of the tile does not fit the texture"),
                     preset.path, 0, JobTexts::tr("Make it smaller, or the texture larger")};
    return made;
}

QString presetText(const MapSettings &settings)
{
    QString text;
    for (const NamedSetting &setting : namedSettings()) {
        if (const std::optional<QString> value = setting.write(settings))
            text += setting.name + (setting.hasValue ? u" = "_s + *value : QString()) + u'\n';
    }
    return text;
}

QStringList settingNames()
{
    QStringList names;
    for (const NamedSetting &setting : namedSettings())
        names << setting.name;
    return names;
}

} // namespace autocuts::jobs
