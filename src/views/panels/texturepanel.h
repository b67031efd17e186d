// The panel with the texture sets of the materials and the light in which they are shown.
#pragma once

#include "model/document/texturesets.h"
#include "views/panels/panel.h"

#include <array>

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
    QWidget *makeComponentRow();
    void fillMaterials();
    void fillChannels();
    void refreshButtons();
    void followSelection();
    int material() const;
    //! The channel of the chosen row.
    TextureChannel channel() const;
    QString fileText(const TextureSet &set, TextureChannel channel) const;
    QString folderToStart() const;
    //! Asks for a picture. \returns an empty string when the user cancelled
    QString askPicture(const QString &title);
    void loadFolder();
    void loadPicture();
    void removePicture();
    void loadPacked(const std::array<TextureChannel, 3> &order);
    void setDirectX(bool on);
    void chooseComponent();
    //! Gives the material's own set a changed version of the channel's picture.
    template <class Edit>
    void editPicture(TextureChannel channel, Edit edit);
    //! Gives the material's own set another picture for the channel; nothing: none of its own.
    void changeOwn(TextureChannel channel, const std::optional<ChannelPicture> &picture);
    void showSets();

    Questions &mQuestions;
    QComboBox *mMaterial;
    QTreeWidget *mList;
    QPushButton *mLoadFolder, *mLoad, *mPacked, *mRemove;
    QComboBox *mComponent;
    QCheckBox *mDirectX;
    LightForm *mLight;
};

} // namespace autocuts
