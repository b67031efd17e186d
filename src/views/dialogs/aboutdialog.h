// The about dialog.
#pragma once

#include <QDialog>

namespace autocuts {

//! Shows the version, the paper, the licence and the libraries.
class AboutDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit AboutDialog(QWidget *parent = nullptr);
};

} // namespace autocuts
