#include "views/dialogs/lampform.h"

#include "views/ui/reasons.h"

#include <Eigen/Geometry>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

enum AreaColumn { Place, Target, Size, Light, AreaColumns };

QString textOf(std::initializer_list<double> numbers, const QString &separator = u", "_s)
{
    QStringList texts;
    for (const double number : numbers)
        texts << QString::number(number, 'g', 6);
    return texts.join(separator);
}

QString textOf(const Vec3f &light)
{
    if (light.minCoeff() == light.maxCoeff())
        return textOf({double(light.x())});
    return textOf({double(light.x()), double(light.y()), double(light.z())});
}

//! Empty unless these are so many finite numbers.
std::vector<double> numbersOf(const QString &text, QChar separator, qsizetype count)
{
    std::vector<double> numbers;
    for (const QString &part : text.split(separator)) {
        bool ok = false;
        numbers.push_back(part.trimmed().toDouble(&ok));
        if (!ok || !(std::abs(numbers.back()) <= 1e9))
            return {};
    }
    return std::ssize(numbers) == count ? numbers : std::vector<double>();
}

std::optional<Vec3f> lightOf(const QString &text)
{
    std::vector<double> numbers = numbersOf(text, u',', 3);
    if (numbers.empty())
        numbers = numbersOf(text, u',', 1);
    if (numbers.empty() || *std::min_element(numbers.begin(), numbers.end()) < 0)
        return std::nullopt;
    numbers.resize(3, numbers.front());
    return Vec3f(Vec3(numbers[0], numbers[1], numbers[2]).cast<float>());
}

QTableWidget *makeTable(const QStringList &titles, const char *name)
{
    auto *table = new QTableWidget(0, static_cast<int>(titles.size()));
    table->setObjectName(QLatin1StringView(name));
    table->setHorizontalHeaderLabels(titles);
    table->verticalHeader()->hide();
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setFixedHeight(4 * table->verticalHeader()->defaultSectionSize());
    return table;
}

} // namespace

LampForm::LampForm(const Scene &scene, const std::vector<LightPlan::Area> &areas, const Emission &emission,
                   QWidget *parent)
    : QWidget(parent),
      mAreas(makeTable({tr("Area light at"), tr("Aimed at"), tr("Size"), tr("Light")}, "areas")),
      mMaterials(makeTable({tr("Emissive material"), tr("Light")}, "shining")), mRemove(new QPushButton)
{
    Eigen::AlignedBox3d box;
    for (const int vertex : scene.mesh->cornerVertex)
        box.extend(Vec3(scene.mesh->positions.row(vertex)));
    if (!box.isEmpty()) {
        mMiddle = box.center();
        mSize = std::max(box.diagonal().norm(), 1e-9);
    }
    mAreas->setToolTip(
        tr("Rectangles that emit light to one side, in units of the model; they are not seen themselves. "
           "Light is red, green, blue, or one number"));
    mMaterials->setToolTip(tr("The faces of a ticked material emit light: red, green, blue or one number"));
    for (const LightPlan::Area &area : areas)
        addRow(area);
    for (const QString &name : scene.materialNames) {
        const int row = mMaterials->rowCount();
        mMaterials->insertRow(row);
        const auto found =
            std::ranges::find_if(emission, [&](const auto &entry) { return entry.first == name; });
        auto *item = new QTableWidgetItem(name);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(found == emission.end() ? Qt::Unchecked : Qt::Checked);
        mMaterials->setItem(row, 0, item);
        mMaterials->setItem(row, 1,
                            new QTableWidgetItem(found == emission.end() ? u"5"_s : textOf(found->second)));
    }
    mMaterials->setVisible(mMaterials->rowCount() > 0);
    auto *add = new QPushButton(tr("Add area &light"));
    add->setObjectName("addLamp"_L1);
    mRemove->setText(tr("Re&move area light"));
    mRemove->setObjectName("removeLamp"_L1);
    showRows();
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {add, mRemove}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(mAreas);
    layout->addLayout(buttons);
    layout->addWidget(mMaterials);
    connect(add, &QPushButton::clicked, this, &LampForm::addLamp);
    connect(mRemove, &QPushButton::clicked, this, &LampForm::removeLamp);
    for (QTableWidget *table : {mAreas, mMaterials})
        connect(table, &QTableWidget::itemChanged, this, &LampForm::changed);
}

void LampForm::addRow(const LightPlan::Area &area)
{
    const int row = mAreas->rowCount();
    mAreas->insertRow(row);
    const auto set = [&](int column, const QString &text) {
        mAreas->setItem(row, column, new QTableWidgetItem(text));
    };
    set(Place, textOf({area.centre.x(), area.centre.y(), area.centre.z()}));
    set(Target, textOf({area.target.x(), area.target.y(), area.target.z()}));
    set(Size, textOf({area.size.x(), area.size.y()}, u" x "_s));
    set(Light, textOf(area.radiance));
}

//! Adds a lamp over the model.
void LampForm::addLamp()
{
    addRow({mMiddle + 0.75 * mSize * mUp, mMiddle, Vec2::Constant(0.5 * mSize), Vec3f::Constant(5)});
    mAreas->setCurrentCell(mAreas->rowCount() - 1, 0);
    showRows();
    Q_EMIT changed();
}

void LampForm::removeLamp()
{
    mAreas->removeRow(std::max(0, mAreas->currentRow()));
    showRows();
    Q_EMIT changed();
}

void LampForm::showRows()
{
    enableOrSay(mRemove, mAreas->rowCount() > 0, tr("There is no area light"));
}

std::optional<std::vector<LightPlan::Area>> LampForm::areas() const
{
    std::vector<LightPlan::Area> areas;
    for (int row = 0; row < mAreas->rowCount(); ++row) {
        const auto text = [&](int column) {
            const QTableWidgetItem *item = mAreas->item(row, column);
            return item ? item->text() : QString();
        };
        const std::vector<double> centre = numbersOf(text(Place), u',', 3);
        const std::vector<double> target = numbersOf(text(Target), u',', 3);
        const std::vector<double> size = numbersOf(text(Size), u'x', 2);
        const std::optional<Vec3f> light = lightOf(text(Light));
        if (centre.empty() || target.empty() || centre == target || size.empty() || !(size[0] > 0) ||
            !(size[1] > 0) || !light)
            return std::nullopt;
        areas.push_back({Vec3(centre.data()), Vec3(target.data()), {size[0], size[1]}, *light});
    }
    return areas;
}

std::optional<LampForm::Emission> LampForm::emission() const
{
    Emission emission;
    for (int row = 0; row < mMaterials->rowCount(); ++row) {
        if (mMaterials->item(row, 0)->checkState() != Qt::Checked)
            continue;
        const std::optional<Vec3f> light = lightOf(mMaterials->item(row, 1)->text());
        if (!light)
            return std::nullopt;
        emission.emplace_back(mMaterials->item(row, 0)->text(), *light);
    }
    return emission;
}

QString LampForm::problem() const
{
    if (!areas())
        return tr(
            "An area light needs two different places (x, y, z), a size (width x height) and its light (a "
            "number, or "
            "red, green, blue).");
    return emission() ? QString() : tr("The light of a material is a number, or red, green, blue.");
}

} // namespace autocuts
