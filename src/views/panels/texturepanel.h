// The panel with the texture sets of the materials and the light in which they are shown.
#pragma once

#include "model/document/texturesets.h"
#include "views/panels/panel.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QTreeWidget;

namespace autocuts {

class LightForm;
class Questions;

//! For the chosen material a list of its channels, with small pictures and the names of the files.
class TexturePanel final : public Panel
{
    Q_OBJECT

public:
    TexturePanel(const StudioContext &context, Questions &questions, QWidget *parent = nullptr);

Q_SIGNALS:
    //! Something was done. \param message translated
    void said(const QString &message);

protected:
    void refresh() override;

private:
    void makeList();
    QWidget *makeButtons();
    void fillMaterials();
    void fillChannels();
    void refreshButtons();
    void followSelection();
    int material() const;
    //! That of the chosen row.
    TextureChannel channel() const;
    QString fileText(const TextureSet &set, TextureChannel channel) const;
    QString folderToStart() const;
    void loadFolder();
    void loadPicture();
    void removePicture();
    void setDirectX(bool on);
    //! Gives the material's own set another picture for the channel; nothing: none of its own.
    void changeOwn(TextureChannel channel, const std::optional<ChannelPicture> &picture);
    void showSets();

    Questions &mQuestions;
    QComboBox *mMaterial;
    QTreeWidget *mList;
    QPushButton *mLoadFolder, *mLoad, *mRemove;
    QCheckBox *mDirectX;
    LightForm *mLight;
};

} // namespace autocuts
