#include "jobs/settingwords.h"

#include "jobs/jobtexts.h"

#include <QStringList>

#include <map>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;

template <>
const Words<StartMode> &wordsOf()
{
    static const Words<StartMode> words{{u"rigid"_s, StartMode::Rigid},
                                        {u"tutte"_s, StartMode::Tutte},
                                        {u"random"_s, StartMode::Random},
                                        {u"uv"_s, StartMode::ExistingUv}};
    return words;
}

template <>
const Words<SeamWeighting> &wordsOf()
{
    static const Words<SeamWeighting> words{{u"length"_s, SeamWeighting::Length},
                                            {u"count"_s, SeamWeighting::Count}};
    return words;
}

template <>
const Words<DistortionEnergy> &wordsOf()
{
    static const Words<DistortionEnergy> words{
        {u"symmetric-dirichlet"_s, DistortionEnergy::SymmetricDirichlet},
        {u"amips"_s, DistortionEnergy::Amips}};
    return words;
}

template <>
const Words<SolverKind> &wordsOf()
{
    static const Words<SolverKind> words{{u"fast"_s, SolverKind::Fast}, {u"exact"_s, SolverKind::Exact}};
    return words;
}

template <>
const Words<unwrap::UnwrapQuality> &wordsOf()
{
    static const Words<unwrap::UnwrapQuality> words{{u"draft"_s, unwrap::UnwrapQuality::Draft},
                                                    {u"standard"_s, unwrap::UnwrapQuality::Standard},
                                                    {u"best"_s, unwrap::UnwrapQuality::Best}};
    return words;
}

template <>
const Words<SurfaceKind> &wordsOf()
{
    static const Words<SurfaceKind> words{{u"auto"_s, SurfaceKind::Auto},
                                          {u"organic"_s, SurfaceKind::Organic},
                                          {u"hard-surface"_s, SurfaceKind::HardSurface}};
    return words;
}

template <>
const Words<FlatMode> &wordsOf()
{
    static const Words<FlatMode> words{{u"rigid"_s, FlatMode::Rigid}, {u"free"_s, FlatMode::Free}};
    return words;
}

template <>
const Words<AlikeMode> &wordsOf()
{
    static const Words<AlikeMode> words{
        {u"off"_s, AlikeMode::Off}, {u"same-cuts"_s, AlikeMode::SameCuts}, {u"stack"_s, AlikeMode::Stack}};
    return words;
}

template <>
const Words<CreaseMode> &wordsOf()
{
    static const Words<CreaseMode> words{
        {u"off"_s, CreaseMode::Off}, {u"auto"_s, CreaseMode::Auto}, {u"on"_s, CreaseMode::On}};
    return words;
}

template <>
const Words<WorldUp> &wordsOf()
{
    static const Words<WorldUp> words{{u"-"_s, WorldUp::Off},
                                      {u"y"_s, WorldUp::Y},
                                      {u"z"_s, WorldUp::Z},
                                      {u"auto-y"_s, WorldUp::AutoY},
                                      {u"auto-z"_s, WorldUp::AutoZ}};
    return words;
}

template <>
const Words<SeamMode> &wordsOf()
{
    static const Words<SeamMode> words{
        {u"free"_s, SeamMode::Free}, {u"keep"_s, SeamMode::Keep}, {u"only"_s, SeamMode::Only}};
    return words;
}

template <>
const Words<PackRotation> &wordsOf()
{
    static const Words<PackRotation> words{
        {u"free"_s, PackRotation::Free},  {u"180"_s, PackRotation::Half},
        {u"90"_s, PackRotation::Quarter}, {u"45"_s, PackRotation::Eighth},
        {u"30"_s, PackRotation::Twelfth}, {u"15"_s, PackRotation::TwentyFourth},
        {u"none"_s, PackRotation::None}};
    return words;
}

std::optional<QString> readTextureSize(PackingSettings &settings, const QString &value)
{
    constexpr int least = 16;
    std::vector<int> sides;
    for (const QString &part : value.split(u'x')) {
        sides.push_back(part.toInt());
        if (sides.back() < least || sides.back() > PackingSettings::maxTextureSize)
            sides.resize(3); // not valid
    }
    if (sides.size() > 2)
        return JobTexts::tr("a whole number from %1 to %2, or two as in 2048x1024")
            .arg(least)
            .arg(PackingSettings::maxTextureSize);
    settings.setTexture(sides.front(), sides.back());
    return std::nullopt;
}

QString textureSizeText(const PackingSettings &settings)
{
    const QString width = QString::number(settings.textureSize);
    return settings.textureHeight > 0 ? u"%1x%2"_s.arg(width).arg(settings.textureHeight) : width;
}

namespace {

const std::map<QString, bool GivenSeamOptions::*> &seamSources()
{
    static const std::map<QString, bool GivenSeamOptions::*> sources{
        {u"cuts"_s, &GivenSeamOptions::cuts},           {u"uv"_s, &GivenSeamOptions::map},
        {u"sharp"_s, &GivenSeamOptions::sharp},         {u"hard"_s, &GivenSeamOptions::hard},
        {u"materials"_s, &GivenSeamOptions::materials},
    };
    return sources;
}

} // namespace

std::optional<QString> readSeamSources(GivenSeamOptions &sources, const QString &value)
{
    const QString expected =
        JobTexts::tr("a list of cuts, uv, sharp, sharp:DEGREES (0 to 180), hard, materials and objects");
    GivenSeamOptions given{.cuts = false, .map = false};
    for (const QString &word : value.split(u',')) {
        if (word == u"objects") // their borders are seams in any case
            continue;
        const qsizetype colon = word.indexOf(u':');
        const auto source = seamSources().find(word.left(colon));
        if (source == seamSources().end() || (colon >= 0 && source->first != u"sharp"))
            return expected;
        given.*source->second = true;
        if (colon >= 0) {
            bool ok = false;
            given.sharpAngle = word.mid(colon + 1).toDouble(&ok);
            if (!ok || !(given.sharpAngle >= 0 && given.sharpAngle <= 180))
                return expected;
        }
    }
    sources = given;
    return std::nullopt;
}

QString seamSourcesText(const GivenSeamOptions &sources)
{
    QStringList words;
    for (const auto &[word, source] : seamSources()) {
        if (sources.*source)
            words << (word == u"sharp" ? u"sharp:%1"_s.arg(sources.sharpAngle) : word);
    }
    return words.isEmpty() ? u"objects"_s : words.join(u',');
}

} // namespace autocuts::jobs
