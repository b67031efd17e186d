// Makes small files of the formats that Assimp alone reads, without any library's writer.
#pragma once

#include <QByteArray>
#include <QString>

#include <utility>
#include <vector>

namespace tradefiles {

//! A sheet that is 2 m wide along x and 1 m high. Where the format holds UVs, they are x / 2 and the height.
struct TradeFile
{
    QString suffix;
    QByteArray bytes;
    bool hasUv = true;
    //! Files that it refers to: name and content.
    std::vector<std::pair<QString, QByteArray>> beside{};
};

//! A zip archive of files: name and content.
QByteArray zip(const std::vector<std::pair<QByteArray, QByteArray>> &files);

//! One file for each of these formats.
std::vector<TradeFile> sheets();

//! An X file of the sheet with weights of bones that may not be there.
QByteArray skinnedX(const std::vector<QByteArray> &bones);
//! A 3MF file of the sheet. \param unit empty: not said \param perMetre units in a metre
QByteArray sheetAs3mf(const QByteArray &unit, double perMetre);
//! An AMF file of the sheet. \param unit empty: not said \param perMetre units in a metre
QByteArray sheetAsAmf(const QByteArray &unit, double perMetre);
//! An OpenGEX file of the sheet. \param metres of its unit \param zUp its axes
QByteArray sheetAsOgex(double metres, bool zUp);

} // namespace tradefiles
