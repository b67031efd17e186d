#include "cli/clivalues.h"

#include "jobs/settingwords.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

std::optional<QString> readRectangle(CliOptions &options, const QString &value)
{
    const QStringList parts = value.split(u',');
    bool allNumbers = parts.size() == 4;
    std::vector<double> sides;
    for (const QString &part : parts) {
        bool ok = false;
        sides.push_back(part.toDouble(&ok));
        allNumbers = allNumbers && ok;
    }
    if (!allNumbers) {
        options.intoRectangle = value;
        return std::nullopt;
    }
    constexpr double farthest = 1000;
    const bool inRange =
        std::all_of(sides.begin(), sides.end(), [](double side) { return std::abs(side) <= farthest; });
    if (!inRange || !(sides[0] < sides[2]) || !(sides[1] < sides[3]))
        return u"left,bottom,right,top in UV units"_s;
    options.unwrap.packing.lower = {sides[0], sides[1]};
    options.unwrap.packing.upper = {sides[2], sides[3]};
    return std::nullopt;
}

std::optional<QString> readTextureSize(CliOptions &options, const QString &value)
{
    return jobs::readTextureSize(options.unwrap.packing, value);
}

std::optional<QString> readTextures(CliOptions &options, const QString &value)
{
    options.textures = value.split(QLatin1Char(','));
    if (options.textures.contains(QString()))
        return QStringLiteral("paths with commas between them");
    return std::nullopt;
}

std::optional<QString> readSeamSources(CliOptions &options, const QString &value)
{
    return jobs::readSeamSources(options.settings.givenSeams, value);
}

namespace {

std::optional<QString> addNames(QStringList &names, const QString &value)
{
    const QStringList more = value.split(u',', Qt::SkipEmptyParts);
    names += more;
    return more.isEmpty() ? std::optional(u"NAME,.."_s) : std::nullopt;
}

} // namespace

std::optional<QString> readObjects(CliOptions &options, const QString &value)
{
    return addNames(options.only.objects, value);
}

std::optional<QString> readMaterials(CliOptions &options, const QString &value)
{
    return addNames(options.only.materials, value);
}

std::optional<QString> readPer(CliOptions &options, const QString &value)
{
    if (value != u"object" && value != u"material")
        return u"object or material"_s;
    options.per = value == u"object" ? SceneKind::Objects : SceneKind::Materials;
    return std::nullopt;
}

std::optional<QString> readFailOn(CliOptions &options, const QString &value)
{
    CliOptions::FailOn failOn;
    const std::map<QString, bool *> flags{{u"overlaps"_s, &failOn.overlaps},
                                          {u"flips"_s, &failOn.flips},
                                          {u"missing"_s, &failOn.missing},
                                          {u"tiles"_s, &failOn.tiles}};
    const std::map<QString, std::optional<double> *> limits{{u"distortion"_s, &failOn.distortion},
                                                            {u"gutter"_s, &failOn.gutter}};
    for (const QString &word : value.split(u',')) {
        const auto flag = flags.find(word);
        const auto limit = limits.find(word.section(u':', 0, 0));
        bool ok = flag != flags.end();
        if (ok)
            *flag->second = true;
        else if (limit != limits.end())
            *limit->second = word.section(u':', 1).toDouble(&ok);
        if (!ok)
            return u"a list of overlaps, flips, missing, tiles, distortion:X and gutter:X"_s;
    }
    options.failOn = failOn;
    return std::nullopt;
}

std::optional<QString> readOnly(CliOptions &options, const QString &value)
{
    static const QString expected = u"islands:N,.. or objects:NAME,.. or materials:NAME,.."_s;
    const qsizetype colon = value.indexOf(u':');
    const QString kind = value.left(colon);
    const QStringList names = value.mid(colon + 1).split(u',', Qt::SkipEmptyParts);
    if (colon < 0 || names.isEmpty())
        return expected;
    if (kind == u"objects") {
        options.only.objects += names;
    } else if (kind == u"materials") {
        options.only.materials += names;
    } else if (kind == u"islands") {
        std::vector<int> numbers;
        for (const QString &name : names) {
            numbers.push_back(name.toInt());
            if (numbers.back() < 1)
                return u"islands by their numbers, from 1"_s;
        }
        options.only.islands.insert(options.only.islands.end(), numbers.begin(), numbers.end());
    } else {
        return expected;
    }
    return std::nullopt;
}

} // namespace autocuts
