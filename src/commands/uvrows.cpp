#include "commands/uvrows.h"

namespace autocuts {

namespace {

using Row = std::array<double, 2>;
static_assert(sizeof(Row) == uvRowSize);

const Row *rowsOf(const UvMatrix &uv)
{
    return reinterpret_cast<const Row *>(uv.data());
}

} // namespace

XorDelta uvDelta(const UvMatrix &from, const UvMatrix &to)
{
    const std::span<const Row> rows(rowsOf(to), static_cast<std::size_t>(to.rows()));
    return XorDelta::between(rowsOf(from), IndexRanges::all(static_cast<int>(from.rows())), rows);
}

UvMatrix toggledRows(const XorDelta &delta, const UvMatrix &current)
{
    const std::vector<Row> rows = delta.applied(rowsOf(current));
    UvMatrix result(static_cast<Eigen::Index>(rows.size()), 2);
    if (!rows.empty())
        std::memcpy(result.data(), rows.data(), rows.size() * sizeof(Row));
    return result;
}

XorDelta readUvDelta(CborReader &reader, const Document &document, const UvMatrix &current)
{
    XorDelta delta = XorDelta::read(reader, uvRowSize, document.mesh().cornerCount(),
                                    document.adjacency().cornersByVertex());
    const UvMatrix rows = toggledRows(delta, current);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        if (rows.row(i).allFinite() && rows.row(i).cwiseAbs().maxCoeff() > maxUvScale)
            reader.fail();
    }
    return delta;
}

} // namespace autocuts
