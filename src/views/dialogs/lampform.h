// The lamps of a light bake: rectangles that shine, and materials that do.
#pragma once

#include "model/document/scene.h"
#include "model/plain/lightplan.h"

#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

class QTableWidget;
class QPushButton;

namespace autocuts {

//! Two tables whose cells are typed into. Light is "r, g, b" or one number for a grey, linear.
class LampForm final : public QWidget
{
    Q_OBJECT

public:
    using Emission = std::vector<std::pair<QString, Vec3f>>;

    //! \param scene whose materials may shine
    LampForm(const Scene &scene, const std::vector<LightPlan::Area> &areas, const Emission &emission,
             QWidget *parent = nullptr);

    //! Nothing where a cell cannot be understood.
    std::optional<std::vector<LightPlan::Area>> areas() const;
    std::optional<Emission> emission() const;
    //! What is wrong, translated; empty when nothing is.
    QString problem() const;
    //! The direction from the model in which new lamps are added.
    void setUp(const Vec3 &up) { mUp = up; }

Q_SIGNALS:
    void changed();

private:
    void addRow(const LightPlan::Area &area);
    void addLamp();
    void removeLamp();
    void showRows();

    Vec3 mMiddle = Vec3::Zero(), mUp = Vec3::UnitY(); //!< of the model
    double mSize = 1;                                 //!< diagonal of the model
    QTableWidget *mAreas, *mMaterials;
    QPushButton *mRemove;
};

} // namespace autocuts
