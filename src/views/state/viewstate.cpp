#include "views/state/viewstate.h"

#include <cmath>

namespace autocuts {

namespace {

using namespace Qt::Literals::StringLiterals;

//! Visits every option with its name in files, so that reading and writing use the same names.
template <typename Options, typename Visit>
void visitFlags(Options &options, Visit visit)
{
    visit("smoothShading"_L1, options.smoothShading);
    visit("livePacking"_L1, options.livePacking);
    visit("wireframe"_L1, options.wireframe);
    visit("seams"_L1, options.seams);
    visit("steering"_L1, options.steering);
    visit("problems"_L1, options.problems);
    visit("fillIslands"_L1, options.fillIslands);
    visit("grid"_L1, options.grid);
    visit("rulers"_L1, options.rulers);
    visit("islandMarks"_L1, options.islandMarks);
    visit("islandNumbers"_L1, options.islandNumbers);
    visit("followMap"_L1, options.followMap);
    visit("orthographic"_L1, options.orthographic);
    visit("xray"_L1, options.xray);
    visit("densityPerCentimetre"_L1, options.densityPerCentimetre);
    visit("showSurroundings"_L1, options.showSurroundings);
}

template <typename Options, typename Visit>
void visitNumbers(Options &options, Visit visit)
{
    visit("stretchClamp"_L1, options.stretchClamp, 0.01, 20.0);
    visit("magnitudeClamp"_L1, options.magnitudeClamp, 4.001, 1e6);
    visit("checkerSize"_L1, options.checkerSize, 1.0, 4096.0);
    visit("letteredCells"_L1, options.letteredCells, 2.0, 26.0);
    visit("densityTarget"_L1, options.densityTarget, 0.0, 1e9);
    visit("densityClamp"_L1, options.densityClamp, 0.01, 20.0);
    visit("densityTolerance"_L1, options.densityTolerance, 0.0, 1.0);
    visit("unitCentimetres"_L1, options.unitCentimetres, 1e-6, 1e9);
    visit("exposure"_L1, options.exposure, -10.0, 10.0);
    visit("lightTurn"_L1, options.lightTurn, -180.0, 180.0);
}

template <typename Enum>
void readEnum(const QCborValue &value, Enum last, Enum &target)
{
    const qint64 number = value.toInteger(-1);
    if (number >= 0 && number <= static_cast<qint64>(last))
        target = static_cast<Enum>(number);
}

} // namespace

QCborMap ViewOptions::toCbor() const
{
    QCborMap map;
    map[u"coloring"_s] = static_cast<qint64>(coloring);
    map[u"pattern"_s] = static_cast<qint64>(pattern);
    visitFlags(*this, [&map](QLatin1StringView key, bool value) { map[key] = value; });
    visitNumbers(*this, [&map](QLatin1StringView key, double value, double, double) { map[key] = value; });
    map[u"texturePath"_s] = texturePath;
    map[u"surroundings"_s] = static_cast<qint64>(surroundings);
    map[u"surroundingsPath"_s] = surroundingsPath;
    map[u"shownChannel"_s] = shownChannel;
    return map;
}

ViewOptions ViewOptions::fromCbor(const QCborMap &map)
{
    ViewOptions options;
    readEnum(map[u"coloring"_s], Coloring::VertexColors, options.coloring);
    readEnum(map[u"pattern"_s], Pattern::Physical, options.pattern); // a bake is not kept
    visitFlags(options, [&map](QLatin1StringView key, bool &value) { value = map[key].toBool(value); });
    visitNumbers(options, [&map](QLatin1StringView key, double &value, double low, double high) {
        const double number = map[key].toDouble(value);
        if (number >= low && number <= high)
            value = number;
    });
    readEnum(map[u"surroundings"_s], Surroundings::File, options.surroundings);
    options.surroundingsPath = map[u"surroundingsPath"_s].toString();
    if (const qint64 channel = map[u"shownChannel"_s].toInteger(-1); channel >= -1 && channel <= 6)
        options.shownChannel = static_cast<int>(channel);
    options.texturePath = map[u"texturePath"_s].toString();
    return options;
}

void ViewState::setOptions(const ViewOptions &options)
{
    if (options == mOptions)
        return;
    mOptions = options;
    Q_EMIT optionsChanged();
}

void ViewState::setTools(const ToolSettings &settings)
{
    if (settings == mTools)
        return;
    mTools = settings;
    Q_EMIT toolsChanged();
}

void ViewState::setHover(const Hover &hover)
{
    if (hover == mHover)
        return;
    mHover = hover;
    Q_EMIT hoverChanged();
}

} // namespace autocuts
