// What the surface reflects in a light bake: the colours of the model, one colour, or a picture.
#pragma once

#include "jobs/lightmaterials.h"

#include <QGroupBox>

class QComboBox;
class QFormLayout;
class QLineEdit;

namespace autocuts {

class ColorButton;
class Questions;

//! A list of these kinds, and the fields of the chosen one.
class AlbedoForm final : public QGroupBox
{
    Q_OBJECT

public:
    //! \param sets that a picture may be for \param last what was chosen last time
    AlbedoForm(const std::vector<UvSet> &sets, const jobs::LightMaterials &last, Questions &questions,
               QWidget *parent = nullptr);

    //! Sets what the surface reflects; the other options stay.
    void apply(jobs::LightMaterials &options) const;
    //! What is wrong, translated; empty when nothing is.
    QString problem() const;

Q_SIGNALS:
    void changed();

private:
    enum class Kind { Model, Color, Picture };

    Kind kind() const;
    QString picture() const;
    void browse();
    void showState();

    Questions &mQuestions;
    QFormLayout *mForm;
    QComboBox *mKind, *mUvSet;
    ColorButton *mColor;
    QLineEdit *mPicture;
    QWidget *mPictureRow;
};

} // namespace autocuts
