// Pictures beside each other on a dark ground, with words below, for the documentation.
#pragma once

#include <QImage>
#include <QStringList>

#include <vector>

namespace autocuts::figures {

//! A column of pictures of one width with words below.
struct Column
{
    std::vector<QImage> pictures;
    QString title;
    QStringList lines;
};

//! The columns from the left to the right.
QImage sheetOf(const std::vector<Column> &columns);

//! Writes a PNG of at most 256 colours, which are chosen for the picture. \returns false when it cannot be
//! written
bool saveSmall(const QImage &picture, const QString &path);

} // namespace autocuts::figures
