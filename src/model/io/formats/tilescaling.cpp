#include "model/io/formats/tilescaling.h"

#include "model/io/formats/filesource.h"

#include <algorithm>

namespace autocuts {

namespace {

//! Divides v. Where the product of the file's v has the same bits, v is that of the file.
void scaleBack(UvMatrix &uv, const UvMatrix *inFile, double tileHeight)
{
    for (Eigen::Index row = 0; row < uv.rows(); ++row) {
        const bool isThere = inFile && (*inFile)(row, 1) * tileHeight == uv(row, 1);
        uv(row, 1) = isThere ? (*inFile)(row, 1) : uv(row, 1) / tileHeight;
    }
}

} // namespace

void scaleFromFile(Scene &scene, double tileHeight)
{
    for (UvSet &set : scene.uvSets)
        set.uv.col(1) *= tileHeight;
}

Scene scaledForFile(const Scene &scene, double tileHeight)
{
    Scene result = scene;
    if (tileHeight == 1)
        return result;
    const FileSource *source = sourceOf(scene);
    const std::vector<UvSet> inFile = source ? source->uvSets(scene) : std::vector<UvSet>();
    for (UvSet &set : result.uvSets) {
        const auto same = std::find_if(inFile.begin(), inFile.end(), [&](const UvSet &other) {
            return other.name == set.name && other.uv.rows() == set.uv.rows();
        });
        scaleBack(set.uv, same == inFile.end() ? nullptr : &same->uv, tileHeight);
    }
    return result;
}

} // namespace autocuts
