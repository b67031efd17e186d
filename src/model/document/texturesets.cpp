#include "model/document/texturesets.h"

#include <QCborMap>

#include <algorithm>
#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qsizetype maxPathLength = 8192;
constexpr double maxFactor = 1e6;

bool isValid(const ChannelPicture &picture)
{
    return picture.component >= -1 && picture.component <= 3 && std::isfinite(picture.factor) &&
           std::abs(picture.factor) <= maxFactor && picture.picture.file.size() <= maxPathLength;
}

} // namespace

double neutralValue(TextureChannel channel)
{
    switch (channel) {
    case TextureChannel::BaseColor:
    case TextureChannel::Normal:
    case TextureChannel::Occlusion:
        return 1;
    case TextureChannel::Roughness:
        return 0.6;
    case TextureChannel::Metalness:
    case TextureChannel::Emission:
    case TextureChannel::Height:
        break;
    }
    return 0;
}

TextureSet overlaid(const TextureSet &below, const TextureSet &above)
{
    TextureSet result = above;
    result.insert(below.begin(), below.end()); // does not replace
    return result;
}

std::vector<TextureSet> withoutEmptyEnd(std::vector<TextureSet> sets)
{
    while (!sets.empty() && sets.back().empty())
        sets.pop_back();
    return sets;
}

QString validateTextureSets(const std::vector<TextureSet> &sets, std::size_t most)
{
    if (sets.size() > most)
        return u"There are more texture sets than materials"_s;
    for (const TextureSet &set : sets) {
        if (!std::all_of(set.begin(), set.end(), [](const auto &entry) { return isValid(entry.second); }))
            return u"A texture set has a value out of range"_s;
    }
    return {};
}

QCborArray toCbor(const std::vector<TextureSet> &sets)
{
    QCborArray array;
    for (const TextureSet &set : sets) {
        QCborArray channels;
        for (const auto &[channel, entry] : set)
            channels.append(QCborMap{{"channel"_L1, static_cast<int>(channel)},
                                     {"file"_L1, entry.picture.file},
                                     {"component"_L1, entry.component},
                                     {"flipped"_L1, entry.flipped},
                                     {"factor"_L1, entry.factor},
                                     {"fromModel"_L1, entry.fromModel}});
        array.append(channels);
    }
    return array;
}

std::optional<std::vector<TextureSet>> readTextureSets(const QCborArray &array, std::size_t most)
{
    if (static_cast<std::size_t>(array.size()) > most)
        return std::nullopt;
    std::vector<TextureSet> sets;
    for (const QCborValue &channels : array) {
        TextureSet &set = sets.emplace_back();
        for (const QCborValue &value : channels.toArray()) {
            const QCborMap map = value.toMap();
            const qint64 channel = map["channel"_L1].toInteger(-1);
            const qint64 component = map["component"_L1].toInteger(-1);
            const ChannelPicture picture{{map["file"_L1].toString(), {}},
                                         static_cast<int>(std::clamp<qint64>(component, -2, 4)),
                                         map["flipped"_L1].toBool(),
                                         map["factor"_L1].toDouble(1),
                                         map["fromModel"_L1].toBool()};
            if (channel < 0 || channel >= textureChannelCount || !isValid(picture))
                return std::nullopt;
            set.emplace(static_cast<TextureChannel>(channel), picture);
        }
    }
    return sets;
}

} // namespace autocuts
