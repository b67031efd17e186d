#include "model/pictures/environment.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace autocuts {

namespace {

using Color = Eigen::Array3f;
using Direction = Eigen::Vector3f;

constexpr float pi = 3.14159265358979F;
constexpr int panoramaWidth = 1024;
constexpr int sampleCount = 64; //!< for each texel of a level, chosen by hand
//! Brighter light, as of a sun in a file, would make speckles. Chosen by hand.
constexpr float brightest = 2000;

//! Longitude and latitude of a direction as places in a panorama, 0 to 1, from the left and from the top.
Eigen::Vector2f placeOf(const Direction &d)
{
    return {0.5F + std::atan2(d.x(), -d.z()) / (2 * pi), std::acos(std::clamp(d.y(), -1.0F, 1.0F)) / pi};
}

Direction directionAt(float x, float y)
{
    const float longitude = (x - 0.5F) * 2 * pi, polar = y * pi;
    return {std::sin(polar) * std::sin(longitude), std::cos(polar), -std::sin(polar) * std::cos(longitude)};
}

//! A panorama, and smaller copies of it, each of half the size.
class Panorama
{
public:
    explicit Panorama(const Picture &picture)
    {
        const int width = std::clamp(picture.width, 8, panoramaWidth), height = std::max(4, width / 2);
        Level &first = mLevels.emplace_back(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x)
                first.at(x, y) = meanOf(picture, x, y, width, height);
        }
        while (mLevels.back().width > 8) {
            Level half(mLevels.back().width / 2, std::max(1, mLevels.back().height / 2));
            const Level &full = mLevels.back();
            for (int y = 0; y < half.height; ++y) {
                for (int x = 0; x < half.width; ++x)
                    half.at(x, y) = (full.at(2 * x, 2 * y) + full.at(2 * x + 1, 2 * y) +
                                     full.at(2 * x, 2 * y + 1) + full.at(2 * x + 1, 2 * y + 1)) /
                                    4;
            }
            mLevels.push_back(std::move(half));
        }
    }

    //! \param level with a fraction; each step is half the size
    Color sample(const Direction &d, float level) const
    {
        const float most = static_cast<float>(mLevels.size()) - 1;
        const float at = std::clamp(level, 0.0F, most);
        const auto lower = static_cast<std::size_t>(at);
        const Color fine = mLevels[lower].sample(placeOf(d));
        const float share = at - static_cast<float>(lower);
        if (share <= 0)
            return fine;
        return fine + share * (mLevels[lower + 1].sample(placeOf(d)) - fine);
    }

    //! Calls with direction, colour and solid angle of all texels of a small copy.
    template <typename Visit>
    void visit(Visit visitTexel) const
    {
        const auto small = std::find_if(mLevels.begin(), mLevels.end(),
                                        [](const Level &level) { return level.width <= 128; });
        for (int y = 0; y < small->height; ++y) {
            const float polar = (static_cast<float>(y) + 0.5F) / static_cast<float>(small->height);
            const float angle =
                std::sin(polar * pi) * 2 * pi * pi / static_cast<float>(small->width * small->height);
            for (int x = 0; x < small->width; ++x)
                visitTexel(
                    directionAt((static_cast<float>(x) + 0.5F) / static_cast<float>(small->width), polar),
                    small->at(x, y), angle);
        }
    }

    int texels() const { return mLevels[0].width * mLevels[0].height; }

private:
    struct Level
    {
        Level(int w, int h) : width(w), height(h), colors(std::size_t(w) * std::size_t(h), Color::Zero()) {}

        int width, height;
        std::vector<Color> colors;

        Color &at(int x, int y) { return colors[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
        const Color &at(int x, int y) const
        {
            return colors[std::size_t(y) * std::size_t(width) + std::size_t(x)];
        }
        Color sample(const Eigen::Vector2f &place) const
        {
            const float x = place.x() * static_cast<float>(width) - 0.5F;
            const float y = place.y() * static_cast<float>(height) - 0.5F;
            const float left = std::floor(x), top = std::floor(y);
            const auto column = [&](float c) { return ((static_cast<int>(c) % width) + width) % width; };
            const auto row = [&](float r) { return std::clamp(static_cast<int>(r), 0, height - 1); };
            const Color upper = at(column(left), row(top)) +
                                (x - left) * (at(column(left + 1), row(top)) - at(column(left), row(top)));
            const Color lower =
                at(column(left), row(top + 1)) +
                (x - left) * (at(column(left + 1), row(top + 1)) - at(column(left), row(top + 1)));
            return upper + (y - top) * (lower - upper);
        }
    };

    //! The mean of the picture's texels that lie in a texel of the first level.
    static Color meanOf(const Picture &picture, int x, int y, int width, int height)
    {
        const auto range = [](int i, int count, int texels) {
            const int first = static_cast<int>(std::int64_t(i) * texels / count);
            const int end = static_cast<int>(std::int64_t(i + 1) * texels / count);
            return std::pair(first, std::max(first + 1, end));
        };
        const auto [x0, x1] = range(x, width, picture.width);
        const auto [y0, y1] = range(y, height, picture.height);
        Color sum = Color::Zero();
        for (int row = y0; row < y1; ++row) {
            for (int column = x0; column < x1; ++column) {
                const auto pixel = picture.at(column, row);
                for (int k = 0; k < 3; ++k) {
                    const float value = pixel[picture.channels < 3 ? 0 : std::size_t(k)];
                    sum[k] += value > 0 ? std::min(value, brightest) : 0; // NaN is 0
                }
            }
        }
        return sum / static_cast<float>((x1 - x0) * (y1 - y0));
    }

    std::vector<Level> mLevels;
};

//! The direction of a texel of a cube map, at -1 to 1 on its face (OpenGL 3.3, table 3.19).
Direction onCube(int face, float s, float t)
{
    switch (face) {
    case 0:
        return Direction(1, -t, -s).normalized();
    case 1:
        return Direction(-1, -t, s).normalized();
    case 2:
        return Direction(s, 1, t).normalized();
    case 3:
        return Direction(s, -1, -t).normalized();
    case 4:
        return Direction(s, -t, 1).normalized();
    default:
        return Direction(-s, -t, -1).normalized();
    }
}

//! A sample of the microfacets' normals around z, distributed as in GGX, and what it is worth.
struct Facet
{
    Direction light; //!< to where a ray that comes along z is reflected
    float weight = 0, level = 0;
};

std::vector<Facet> facets(float roughness, int panoramaTexels)
{
    const float alpha = roughness * roughness;
    std::vector<Facet> result;
    for (std::uint32_t i = 0; i < sampleCount; ++i) {
        // Hammersley points: the digits of i in base two, mirrored at the point.
        std::uint32_t bits = 0;
        for (int b = 0; b < 32; ++b)
            bits |= (i >> b & 1U) << (31 - b);
        const float u = (static_cast<float>(i) + 0.5F) / sampleCount;
        const float v = static_cast<float>(bits) * 2.3283064365386963e-10F;
        const float cosine = std::sqrt((1 - v) / (1 + (alpha * alpha - 1) * v));
        const float sine = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
        const Direction half(sine * std::cos(2 * pi * u), sine * std::sin(2 * pi * u), cosine);
        const Direction light = 2 * cosine * half - Direction::UnitZ();
        if (light.z() <= 0)
            continue;
        const float d = cosine * cosine * (alpha * alpha - 1) + 1;
        const float density = alpha * alpha / (pi * d * d) / 4;
        const float sampleAngle = 1 / (sampleCount * std::max(density, 1e-6F));
        const float texelAngle = 4 * pi / static_cast<float>(panoramaTexels);
        result.push_back({light, light.z(), 0.5F * std::log2(sampleAngle / texelAngle) + 1});
    }
    return result;
}

Color reflected(const Panorama &panorama, const Direction &normal, const std::vector<Facet> &samples)
{
    const Direction other = std::abs(normal.y()) < 0.9F ? Direction::UnitY() : Direction::UnitX();
    const Direction x = other.cross(normal).normalized(), y = normal.cross(x);
    Color sum = Color::Zero();
    float weight = 0;
    for (const Facet &facet : samples) {
        const Direction light = facet.light.x() * x + facet.light.y() * y + facet.light.z() * normal;
        sum += facet.weight * panorama.sample(light, facet.level);
        weight += facet.weight;
    }
    return sum / weight;
}

void addIrradiance(const Panorama &panorama, Environment &environment)
{
    std::array<Color, 9> sums;
    sums.fill(Color::Zero());
    panorama.visit([&](const Direction &d, const Color &color, float angle) {
        const std::array<float, 9> basis{0.282095F,
                                         0.488603F * d.y(),
                                         0.488603F * d.z(),
                                         0.488603F * d.x(),
                                         1.092548F * d.x() * d.y(),
                                         1.092548F * d.y() * d.z(),
                                         0.315392F * (3 * d.z() * d.z() - 1),
                                         1.092548F * d.x() * d.z(),
                                         0.546274F * (d.x() * d.x() - d.y() * d.y())};
        for (std::size_t k = 0; k < 9; ++k)
            sums[k] += angle * basis[k] * color;
    });
    // The cosine lobe, over pi: what a white surface gives back.
    constexpr std::array<float, 9> lobe{1, 2.0F / 3, 2.0F / 3, 2.0F / 3, 0.25F, 0.25F, 0.25F, 0.25F, 0.25F};
    constexpr std::array<float, 9> scale{0.282095F, 0.488603F, 0.488603F, 0.488603F, 1.092548F,
                                         1.092548F, 0.315392F, 1.092548F, 0.546274F};
    for (std::size_t k = 0; k < 9; ++k) {
        const Color value = sums[k] * lobe[k] * scale[k];
        environment.irradiance[k] = {value[0], value[1], value[2]};
    }
}

//! A soft rectangle of light around a direction. \param wide, high half sizes in degrees
struct Softbox
{
    float longitude, latitude, wide, high;
    Color color;
};

float edge(float distance, float half, float soft)
{
    const float t = std::clamp((half + soft - distance) / (2 * soft), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

template <typename Paint>
Picture painted(Paint paint)
{
    constexpr int width = 512, height = 256;
    Picture picture(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float longitude = ((static_cast<float>(x) + 0.5F) / width - 0.5F) * 360;
            const float latitude = 90 - (static_cast<float>(y) + 0.5F) / height * 180;
            const Color color = paint(longitude, latitude);
            std::copy_n(color.data(), 3, picture.at(x, y).data());
        }
    }
    return picture;
}

} // namespace

Environment prepareEnvironment(const Picture &picture, const std::atomic<bool> *stop)
{
    Environment environment;
    if (picture.isEmpty())
        return environment;
    const Panorama panorama(picture);
    for (int level = 0; level < Environment::levelCount; ++level) {
        const int side = Environment::sideOf(level);
        std::vector<float> &values = environment.levels[static_cast<std::size_t>(level)];
        values.reserve(std::size_t(18) * std::size_t(side) * std::size_t(side));
        const std::vector<Facet> samples =
            facets(static_cast<float>(level) / (Environment::levelCount - 1), panorama.texels());
        for (int face = 0; face < 6; ++face) {
            for (int y = 0; y < side; ++y) {
                if (stop && *stop)
                    return {};
                for (int x = 0; x < side; ++x) {
                    const auto place = [side](int i) {
                        return 2 * (static_cast<float>(i) + 0.5F) / static_cast<float>(side) - 1;
                    };
                    const Direction d = onCube(face, place(x), place(y));
                    const Color color = level == 0 ? panorama.sample(d, 0) : reflected(panorama, d, samples);
                    values.insert(values.end(), color.data(), color.data() + 3);
                }
            }
        }
    }
    addIrradiance(panorama, environment);
    return environment;
}

Picture studioPanorama()
{
    // Longitude 0 is behind the model, 180 where the viewer is.
    const std::array<Softbox, 5> lights{
        {{-128, 38, 30, 24, Color(7.5F, 7.2F, 6.8F)},   // key, left of the viewer
         {115, 12, 20, 38, Color(2.2F, 2.4F, 2.8F)},    // fill, right
         {28, 34, 26, 14, Color(7.0F, 7.4F, 8.2F)},     // rim, behind right
         {-38, 6, 8, 46, Color(5.5F, 5.3F, 5.0F)},      // rim, behind left
         {180, 82, 180, 12, Color(3.2F, 3.2F, 3.3F)}}}; // above
    return painted([&](float longitude, float latitude) {
        const float up = latitude / 90;
        Color color = Color(0.20F, 0.21F, 0.23F) + std::max(0.0F, up) * Color(0.22F, 0.22F, 0.23F);
        if (up < 0)
            color += std::min(1.0F, -up * 1.6F) * Color(0.10F, 0.095F, 0.09F);
        for (const Softbox &light : lights) {
            float away = std::abs(longitude - light.longitude);
            away = std::min(away, 360 - away);
            const float share =
                edge(away, light.wide, 3.5F) * edge(std::abs(latitude - light.latitude), light.high, 3.5F);
            color += share * light.color;
        }
        return color;
    });
}

Picture skyPanorama()
{
    constexpr float sunLongitude = -125, sunLatitude = 42;
    const Direction sun = directionAt(0.5F + sunLongitude / 360, 0.5F - sunLatitude / 180);
    return painted([&](float longitude, float latitude) {
        const Direction d = directionAt(0.5F + longitude / 360, 0.5F - latitude / 180);
        const float height = std::max(0.0F, d.y());
        const float toSun = std::max(0.0F, d.dot(sun));
        const Color zenith(0.20F, 0.38F, 0.82F), horizon(0.86F, 0.93F, 1.02F), ground(0.36F, 0.33F, 0.29F);
        Color sky = horizon + std::pow(height, 0.45F) * (zenith - horizon);
        sky += std::pow(toSun, 8.0F) * Color(0.45F, 0.36F, 0.22F);
        sky += std::pow(toSun, 90.0F) * Color(5, 4.5F, 3.6F);
        sky += std::pow(toSun, 900.0F) * Color(90, 84, 72);
        const float above = edge(-d.y(), 0, 0.03F);
        return Color(ground + above * (sky - ground));
    });
}

} // namespace autocuts
