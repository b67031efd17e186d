// What is to be baked, as the user chose it.
#pragma once

#include <QCborMap>
#include <QString>
#include <QStringList>

namespace autocuts {

//! A bake into the active UV set.
struct BakeChoice
{
    enum class Direction { Smoothed, Shading, Corrected };

    QString high; //!< file of the detailed model; empty: the model itself
    QStringList maps{QStringLiteral("normal"), QStringLiteral("ao")}; //!< names as in options: "normal"
    int width = 0;          //!< of the pictures, in texels; 0: that of the document's texture
    int samplesPerSide = 2; //!< of each texel
    int rays = 64;          //!< per texel
    double cage = 0.02;     //!< share of the diagonal of the model's bounding box
    Direction direction = Direction::Smoothed;
    bool byName = false;    //!< objects see those of the same name only
    bool greenDown = false; //!< normals for DirectX
    int dilation = 16;      //!< texels
    QString suffix = QStringLiteral("png");
    int bits = 8;
    QString folder; //!< for the pictures

    bool operator==(const BakeChoice &) const = default;
    //! For the session. The dialog takes nothing from it that cannot be chosen there.
    QCborMap toCbor() const;
    static BakeChoice fromCbor(const QCborMap &map);
};

//! The names of all maps that can be baked.
QStringList bakeMapNames();
//! Translated; empty where the title says all. \param name one of bakeMapNames()
QString bakeMapTitle(const QString &name);
QString bakeMapTip(const QString &name);

} // namespace autocuts
