// Autocuts for C++: UV maps of polygon meshes. Wraps autocuts.h, which says units and conventions; nothing
// but the standard library and that header is needed. Functions throw Error.
#ifndef AUTOCUTS_HPP
#define AUTOCUTS_HPP

#include <autocuts/autocuts.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace autocuts {

//! What went wrong; what() has the problem and the remedy.
class Error : public std::runtime_error
{
public:
    Error(autocuts_status status, const autocuts_error &error)
        : std::runtime_error(error.remedy[0] ? std::string(error.message) + ". " + error.remedy
                                             : error.message),
          mStatus(status), mRemedy(error.remedy)
    {}
    autocuts_status status() const { return mStatus; }
    const std::string &remedy() const { return mRemedy; }

private:
    autocuts_status mStatus;
    std::string mRemedy;
};

//! A view of a mesh; the arrays must live as long as it is used. Empty spans are left out.
struct Mesh
{
    std::span<const double> positions;             //!< x, y, z of each vertex
    std::span<const std::uint32_t> indices;        //!< the vertex of each corner
    std::span<const std::uint32_t> faceSizes = {}; //!< empty: triangles
    std::span<const std::int32_t> faceObjects = {};
    std::span<const double> uvs = {}; //!< u, v of each corner
    std::span<const std::uint8_t> lockedFaces = {};
    std::span<const std::uint8_t> edges = {}; //!< autocuts_edge of each corner
};

//! Receives a share from 0 to 1; returns false to stop with the best map so far.
using Progress = std::function<bool(double fraction)>;

//! The defaults are those of autocuts-cli.
struct Options : autocuts_options
{
    Options() { autocuts_options_init(this); }
};

using Figures = autocuts_figures;

//! A map; what it gives out lives as long as it does.
class Map
{
public:
    explicit Map(autocuts_map *map) : mMap(map, autocuts_map_free) {}
    //! u, v of each corner.
    std::span<const double> uvs() const { return {autocuts_map_uvs(mMap.get()), 2 * corners()}; }
    //! The island of each face, from 0; -1 without UVs.
    std::span<const std::int32_t> islands() const
    {
        return {autocuts_map_islands(mMap.get()), autocuts_map_face_count(mMap.get())};
    }
    //! Per corner: 1 when the edge to the next corner of its face is a seam or a border.
    std::span<const std::uint8_t> seams() const { return {autocuts_map_seams(mMap.get()), corners()}; }
    std::size_t islandCount() const { return autocuts_map_island_count(mMap.get()); }
    bool stopped() const { return autocuts_map_stopped(mMap.get()) != 0; }
    Figures measure() const
    {
        Figures figures{};
        autocuts_error error{};
        if (const autocuts_status status = autocuts_measure(mMap.get(), &figures, &error);
            status != AUTOCUTS_OK)
            throw Error(status, error);
        return figures;
    }

private:
    std::size_t corners() const { return autocuts_map_corner_count(mMap.get()); }
    std::unique_ptr<autocuts_map, void (*)(autocuts_map *)> mMap;
};

namespace detail {

inline autocuts_mesh viewOf(const Mesh &mesh)
{
    const auto fail = [](const char *message) {
        autocuts_error error{};
        std::string(message).copy(error.message, sizeof error.message - 1);
        throw Error(AUTOCUTS_BAD_INPUT, error);
    };
    std::size_t faces = mesh.faceSizes.size(), corners = 0;
    for (const std::uint32_t size : mesh.faceSizes)
        corners += size;
    if (mesh.faceSizes.empty()) {
        faces = mesh.indices.size() / 3;
        corners = 3 * faces;
    }
    if (mesh.positions.size() % 3 != 0)
        fail("positions have three numbers per vertex");
    if (mesh.indices.size() != corners)
        fail("there are not as many indices as the faces have corners");
    if (!mesh.faceObjects.empty() && mesh.faceObjects.size() != faces)
        fail("there is not one object per face");
    if (!mesh.uvs.empty() && mesh.uvs.size() != 2 * corners)
        fail("there are not two UV numbers per corner");
    if (!mesh.lockedFaces.empty() && mesh.lockedFaces.size() != faces)
        fail("there is not one lock per face");
    if (!mesh.edges.empty() && mesh.edges.size() != corners)
        fail("there is not one edge per corner");
    const auto orNull = [](const auto &span) { return span.empty() ? nullptr : span.data(); };
    autocuts_mesh view{};
    view.positions = mesh.positions.data();
    view.vertex_count = mesh.positions.size() / 3;
    view.face_sizes = orNull(mesh.faceSizes);
    view.face_count = faces;
    view.indices = mesh.indices.data();
    view.face_objects = orNull(mesh.faceObjects);
    view.uvs = orNull(mesh.uvs);
    view.locked_faces = orNull(mesh.lockedFaces);
    view.edges = orNull(mesh.edges);
    return view;
}

template <class Call>
Map run(Call call, const Mesh &mesh, Options options, const Progress &progress)
{
    if (progress) {
        options.user = const_cast<Progress *>(&progress);
        options.progress = [](double fraction, void *user) {
            return (*static_cast<const Progress *>(user))(fraction) ? 0 : 1;
        };
    }
    const autocuts_mesh view = viewOf(mesh);
    autocuts_map *map = nullptr;
    autocuts_error error{};
    if (const autocuts_status status = call(&view, &options, &map, &error); status != AUTOCUTS_OK)
        throw Error(status, error);
    return Map(map);
}

} // namespace detail

//! Cuts, maps and packs.
inline Map unwrap(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_unwrap, mesh, options, progress);
}
//! Packs the islands of mesh.uvs.
inline Map pack(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_pack, mesh, options, progress);
}
//! Cuts the islands of mesh.uvs that overlap themselves, and packs.
inline Map separate(const Mesh &mesh, const Options &options = {}, const Progress &progress = {})
{
    return detail::run(autocuts_separate, mesh, options, progress);
}
//! mesh.uvs as a map, to be measured.
inline Map take(const Mesh &mesh, const Options &options = {})
{
    return detail::run(autocuts_take, mesh, options, {});
}

} // namespace autocuts

#endif
