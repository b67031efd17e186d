// What is to be baked, as the user chose it.
#pragma once

#include "model/io/outputs/bakefiles.h"
#include "solver/bake/bakemaps.h"

#include <QCborMap>
#include <QString>
#include <QStringList>

namespace autocuts::jobs {

//! The settings of a bake into the active UV set.
struct BakeChoice
{
    QString high; //!< file of the detailed model; empty: the model itself
    QStringList maps{QStringLiteral("normal"), QStringLiteral("ao")}; //!< names as in options: "normal"
    int width = 0;          //!< of the pictures, in texels; 0: that of the document's texture
    int samplesPerSide = 2; //!< of each texel
    int rays = 64;          //!< per texel
    //! Distance of the cage, as a share of the diagonal of the model's bounding box. Unless ownCage, each
    //! bake measures it, and this is the value that was shown last.
    double cage = 0.02;
    bool ownCage = false; //!< the user has typed it
    QString cageFile;     //!< in place of the distance; empty: none
    bake::CageDirection direction = bake::CageDirection::Smoothed;
    double reach = 0; //!< how far away things occlude, as a share of the diagonal; 0: at any distance
    double curvatureRadius = 0.01, thicknessLimit = 0.25; //!< shares of the diagonal
    ColorSource colors = ColorSource::Auto;
    bool byName = false;    //!< each object is baked from the detailed ones of its name only
    bool greenDown = false; //!< normals for DirectX
    int dilation = 16;      //!< texels
    QString suffix = QStringLiteral("png");
    int bits = 8;      //!< of each number; 0: 8, and 32 in exr
    QString folder;    //!< for the pictures
    bool putOn = true; //!< normals, occlusion and colours become textures of the model

    //! True when at least one of the maps becomes a texture of the model.
    bool isPutOn() const;
    bool operator==(const BakeChoice &) const = default;
    //! For the session. The dialog takes nothing from it that cannot be chosen there.
    QCborMap toCbor() const;
    static BakeChoice fromCbor(const QCborMap &map);
};

//! The names of all maps that can be baked.
QStringList bakeMapNames();
//! True for maps that materials have a place for. \param name one of bakeMapNames()
bool isTextureOfMaterials(const QString &name);

} // namespace autocuts::jobs
