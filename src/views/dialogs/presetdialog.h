// A dialog that asks for the name under which settings are saved.
#pragma once

#include <QDialog>
#include <QStringList>

class QComboBox;
class QPushButton;

namespace autocuts {

//! Asks for the name of a preset, a new one or one that there is.
class PresetDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param names of the presets of the user
    explicit PresetDialog(const QStringList &names, QWidget *parent = nullptr);

    QString name() const;

private:
    void enableSave();

    QComboBox *mName;
    QPushButton *mSave;
};

} // namespace autocuts
