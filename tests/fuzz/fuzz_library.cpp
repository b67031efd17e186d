// Fuzzes the C interface: small meshes of any bytes, with any wishes. A call fails with a message, or gives a
// map whose numbers are finite or NaN, and that measures.
#include <autocuts/autocuts.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <vector>

namespace {

//! Gives out the bytes of the fuzzer; 0 after the last one.
class Bytes
{
public:
    Bytes(const std::uint8_t *data, std::size_t size) : mData(data), mSize(size) {}

    unsigned next() { return mAt < mSize ? mData[mAt++] : 0U; }
    bool flag() { return next() % 2 == 1; }
    //! A coarse number, so that places coincide, or sometimes none at all.
    double number()
    {
        const unsigned byte = next();
        if (byte == 255)
            return std::nan("");
        if (byte == 254)
            return 1e160;
        return double(byte % 16) - 4;
    }
    std::vector<double> numbers(std::size_t count)
    {
        std::vector<double> result(count);
        for (double &value : result)
            value = number();
        return result;
    }
    template <class T>
    std::vector<T> small(std::size_t count, int least, unsigned range)
    {
        std::vector<T> result(count);
        for (T &value : result)
            value = static_cast<T>(least + int(next() % range));
        return result;
    }

private:
    const std::uint8_t *mData;
    std::size_t mSize, mAt = 0;
};

void require(bool holds)
{
    if (!holds)
        std::abort();
}

//! A job ends after so many reports, so that one input takes no long time.
int hurry(double, void *calls)
{
    return ++*static_cast<int *>(calls) > 20 ? 1 : 0;
}

autocuts_options optionsFrom(Bytes &bytes, int *calls)
{
    autocuts_options options;
    autocuts_options_init(&options);
    options.quality = AUTOCUTS_DRAFT;
    options.seams = int(bytes.next() % 3);
    options.seams_from = bytes.next() % 32;
    options.surface = int(bytes.next() % 3);
    options.alike = int(bytes.next() % 3);
    options.align = int(bytes.next() % 3);
    options.symmetry = bytes.flag() ? AUTOCUTS_SYMMETRY_ON : AUTOCUTS_SYMMETRY_AUTO;
    options.texture_width = options.texture_height = 64 << bytes.next() % 4;
    options.margin = bytes.next() % 8;
    options.pack_time = 0.01;
    options.progress = hurry;
    options.user = calls;
    return options;
}

void checkMap(autocuts_map *map)
{
    const std::size_t corners = autocuts_map_corner_count(map);
    for (std::size_t i = 0; i < 2 * corners; ++i)
        require(!std::isinf(autocuts_map_uvs(map)[i]));
    autocuts_figures figures;
    require(autocuts_measure(map, &figures, nullptr) == AUTOCUTS_OK);
    std::vector<std::uint8_t> picture(4 * 16 * 16);
    require(autocuts_draw(map, 1001, 16, 16, picture.data(), nullptr) == AUTOCUTS_OK);
    autocuts_map_free(map);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    Bytes bytes(data, size);
    const std::size_t vertices = bytes.next() % 24, faces = bytes.next() % 24;
    const std::vector<double> positions = bytes.numbers(3 * vertices);
    const std::vector<std::uint32_t> sizes = bytes.small<std::uint32_t>(faces, 3, 3);
    std::size_t corners = 0;
    for (const std::uint32_t count : sizes)
        corners += count;
    const auto range = unsigned(vertices == 0 ? 1 : vertices + (bytes.next() == 7 ? 1 : 0));
    const auto indices = bytes.small<std::uint32_t>(corners, 0, range);
    const auto objects = bytes.small<std::int32_t>(faces, 0, 2);
    const auto edges = bytes.small<std::uint8_t>(corners, 0, 3);
    const auto locked = bytes.small<std::uint8_t>(faces, 0, 2);
    const std::vector<double> uvs = bytes.numbers(2 * corners), normals = bytes.numbers(3 * corners);
    const std::vector<double> weights = bytes.numbers(corners);
    const std::vector<autocuts_pin> pins{
        {bytes.next(), bytes.number(), bytes.number(), double(bytes.next() % 2)},
        {bytes.next(), bytes.number(), bytes.number(), 0}};
    autocuts_mesh mesh{};
    mesh.positions = positions.data();
    mesh.vertex_count = vertices;
    mesh.face_sizes = sizes.data();
    mesh.face_count = faces;
    mesh.indices = indices.data();
    if (bytes.flag())
        mesh.face_objects = objects.data();
    if (bytes.flag())
        mesh.edges = edges.data();
    if (bytes.flag())
        mesh.uvs = uvs.data();
    if (bytes.flag())
        mesh.locked_faces = locked.data();
    if (bytes.flag())
        mesh.normals = normals.data();
    if (bytes.next() % 8 == 1)
        mesh.edge_weights = weights.data();
    if (bytes.next() % 4 == 1) {
        mesh.pins = pins.data();
        mesh.pin_count = pins.size();
    }
    int calls = 0;
    const autocuts_options options = optionsFrom(bytes, &calls);
    using Job = autocuts_status (*)(const autocuts_mesh *, const autocuts_options *, autocuts_map **,
                                    autocuts_error *);
    constexpr Job jobs[]{autocuts_unwrap,   autocuts_finish, autocuts_pack, autocuts_separate,
                         autocuts_lightmap, autocuts_align,  autocuts_take};
    autocuts_map *map = nullptr;
    autocuts_error error{};
    const autocuts_status status = jobs[bytes.next() % std::size(jobs)](&mesh, &options, &map, &error);
    require((status == AUTOCUTS_OK) == (map != nullptr));
    require(status == AUTOCUTS_OK || (status != AUTOCUTS_FAILED && std::strlen(error.message) > 0));
    if (map)
        checkMap(map);
    return 0;
}
