// What the program is, whose work it stands on, and its licence.
#pragma once

#include <QDialog>

namespace autocuts {

//! Version, paper, licence, libraries.
class AboutDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit AboutDialog(QWidget *parent = nullptr);
};

} // namespace autocuts
