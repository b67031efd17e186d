// Colours that a file gives the corners of polygons (vertex colours). Plain: no Qt.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace autocuts {

//! The colour of one corner. 8 bytes, since large models have many corners.
struct CornerColor
{
    std::array<std::uint16_t, 3> linear{}; //!< red, green and blue in linear light; 65535 is 1
    bool known = false;                    //!< false: the file says nothing of this corner

    //! Numbers from 0 to 1 in linear light; what is outside is clamped. Not known when one is not finite.
    static CornerColor fromLinear(double red, double green, double blue);
    //! The same for numbers of sRGB.
    static CornerColor fromSrgb(double red, double green, double blue);
    Eigen::Vector3f value() const { return Eigen::Vector3f(linear[0], linear[1], linear[2]) / 65535; }

    bool operator==(const CornerColor &) const = default;
};

using CornerColors = std::vector<CornerColor>;

//! The colours to be shared; null when none is known. \param colors padded to `corners` with unknown ones
std::shared_ptr<const CornerColors> sharedColors(CornerColors colors, std::size_t corners);

} // namespace autocuts
