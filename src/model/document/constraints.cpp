#include "model/document/constraints.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

const UvPin *Constraints::pin(int corner) const
{
    const auto it = std::lower_bound(pins.begin(), pins.end(), corner,
                                     [](const UvPin &p, int c) { return p.corner < c; });
    return it != pins.end() && it->corner == corner ? &*it : nullptr;
}

const LayoutRectangle *Constraints::rectangle(int id) const
{
    const auto it = std::lower_bound(rectangles.begin(), rectangles.end(), id,
                                     [](const LayoutRectangle &r, int i) { return r.id < i; });
    return it != rectangles.end() && it->id == id ? &*it : nullptr;
}

int Constraints::nextRectangleId() const
{
    int id = 1;
    for (const LayoutRectangle &rectangle : rectangles) {
        if (rectangle.id != id)
            break;
        ++id;
    }
    return id <= maxRectangleId ? id : 0;
}

QString Constraints::validate(const MeshData &mesh) const
{
    for (std::size_t i = 0; i < pins.size(); ++i) {
        if (!isValid(pins[i], mesh))
            return QStringLiteral("Pin %1 is not valid").arg(i);
        if (i > 0 && pins[i - 1].corner >= pins[i].corner)
            return QStringLiteral("The pins are not in order");
    }
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
        if (!isValid(rectangles[i], mesh))
            return QStringLiteral("Rectangle %1 is not valid").arg(i);
        if (i > 0 && rectangles[i - 1].id >= rectangles[i].id)
            return QStringLiteral("The rectangles are not in order");
    }
    return {};
}

bool isValid(const UvPin &pin, const MeshData &mesh)
{
    return pin.corner >= 0 && pin.corner < mesh.cornerCount() && pin.position.allFinite() &&
           std::isfinite(pin.weight) && pin.weight >= 0;
}

bool isValid(const LayoutRectangle &rectangle, const MeshData &mesh)
{
    return rectangle.id > 0 && rectangle.id <= maxRectangleId && rectangle.lower.allFinite() &&
           rectangle.upper.allFinite() && rectangle.lower.x() <= rectangle.upper.x() &&
           rectangle.lower.y() <= rectangle.upper.y() && std::isfinite(rectangle.weight) &&
           rectangle.weight >= 0 && rectangle.name.size() <= maxNameLength &&
           isIndexSet(rectangle.faces, mesh.faceCount());
}

bool isIndexSet(const QList<int> &indices, int count)
{
    if (indices.isEmpty())
        return true;
    return indices.first() >= 0 && indices.last() < count &&
           std::adjacent_find(indices.begin(), indices.end(), std::greater_equal<>()) == indices.end();
}

} // namespace autocuts
