// FBX files come back changed in nothing but their UVs.
#include "model/io/fbx/fbxparsing.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxrewriter.h"
#include "model/io/meshes/exportlosses.h"
#include "support/fbxfiles.h"

#include <QTest>

#include <limits>

namespace tst_fbxrewriter {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using fbxfiles::Kind;
using fbxfiles::Node;
using fbxfiles::Object;

namespace {

constexpr double noUv = std::numeric_limits<double>::quiet_NaN();

Scene parsed(const QByteArray &bytes)
{
    Result<Scene> scene = parseFbx(bytes, u"a.fbx"_s);
    if (!scene)
        qFatal("%s", qPrintable(scene.error().toString()));
    return std::move(scene).value();
}

QByteArray written(const Scene &scene)
{
    return rewriteFbx(*sourceOf<FbxSource>(scene), scene);
}

FbxTree treeOf(const QByteArray &bytes)
{
    return parseFbxTree(bytes, u"a.fbx"_s).value();
}

//! All nodes as paths and values, but those that say UVs: what has to stay.
QByteArrayList unchanging(const QByteArray &bytes)
{
    const FbxTree tree = treeOf(bytes);
    QByteArrayList list;
    std::vector<QByteArray> paths(tree.nodes.size());
    for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
        const FbxNode &node = tree.nodes[n];
        const int index = static_cast<int>(n);
        const QByteArray &above = paths[static_cast<std::size_t>(node.parent)];
        const bool ofUv = tree.name(index) == "LayerElementUV" ||
                          tree.text(tree.child(index, "Type")) == "LayerElementUV" || above == "UV";
        paths[n] = ofUv ? QByteArray("UV")
                        : above + '/' + QByteArray(tree.name(index).data(), std::ssize(tree.name(index)));
        if (!ofUv)
            list << paths[n] + ' ' + bytes.sliced(node.valuesBegin, node.valuesEnd - node.valuesBegin);
    }
    list << (tree.binary ? bytes.sliced(tree.footer).right(140) : QByteArray());
    return list;
}

UvMatrix otherUv(const MeshData &mesh, double shift = 0)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) << 0.1 * mesh.cornerVertex[c] + shift, 1.0 / 3 + mesh.cornerVertex[c];
    return uv;
}

bool sameUv(const UvMatrix &a, const UvMatrix &b)
{
    if (a.rows() != b.rows())
        return false;
    for (Eigen::Index row = 0; row < a.rows(); ++row) {
        const bool has = a.row(row).allFinite();
        if (has != b.row(row).allFinite() || (has && a.row(row) != b.row(row)))
            return false;
    }
    return true;
}

const Node unknownElement{"LayerElementColor", {std::int32_t(0)}, {{"Name", {QByteArray("kept")}, {}}}};

//! An object of two quads with these sets, each in a layer of its own.
Object quadObject(const QByteArray &name, const std::vector<QByteArray> &sets)
{
    std::vector<Node> more;
    std::vector<Node> layers;
    for (int s = 0; s < std::ssize(sets); ++s) {
        more.push_back(fbxfiles::uvElement(s, sets[s]));
        layers.push_back(fbxfiles::layer(s, {s}));
    }
    if (layers.empty())
        layers.push_back(fbxfiles::layer(0, {}));
    more.push_back(unknownElement);
    more.insert(more.end(), layers.begin(), layers.end());
    return {name, fbxfiles::quads(more)};
}

//! For each layer of the first mesh, the numbers of the UV sets that it names; "0|1" for two layers.
QString layersOf(const QByteArray &bytes)
{
    const FbxTree tree = treeOf(bytes);
    int mesh = tree.child(tree.child(0, "Objects"), "Geometry");
    if (mesh < 0)
        mesh = tree.child(tree.child(0, "Objects"), "Model");
    QStringList layers;
    for (int l = tree.child(mesh, "Layer"); l >= 0; l = tree.nextNamed(l)) {
        QString text;
        for (int e = tree.child(l, "LayerElement"); e >= 0; e = tree.nextNamed(e)) {
            if (tree.text(tree.child(e, "Type")) == "LayerElementUV")
                text += QString::number(tree.integer(tree.child(e, "TypedIndex")).value_or(-1));
        }
        layers << text;
    }
    return layers.join(u'|');
}

//! The numbers and names of the LayerElementUV nodes of the first mesh.
QStringList elementsOf(const QByteArray &bytes)
{
    const FbxTree tree = treeOf(bytes);
    int mesh = tree.child(tree.child(0, "Objects"), "Geometry");
    if (mesh < 0)
        mesh = tree.child(tree.child(0, "Objects"), "Model");
    QStringList elements;
    for (int e = tree.child(mesh, "LayerElementUV"); e >= 0; e = tree.nextNamed(e)) {
        const std::string_view name = tree.text(tree.child(e, "Name"));
        elements << u"%1 %2"_s.arg(tree.integer(e).value_or(-1))
                        .arg(QString::fromUtf8(name.data(), std::ssize(name)));
    }
    return elements;
}

void addKinds()
{
    QTest::addColumn<Kind>("kind");
    QTest::newRow("binary 6100") << Kind{true, 6100};
    QTest::newRow("binary 7100 big-endian") << Kind{true, 7100, true};
    QTest::newRow("binary 7400") << Kind{true, 7400};
    QTest::newRow("binary 7700") << Kind{true, 7700};
    QTest::newRow("text 6100") << Kind{false, 6100};
    QTest::newRow("text 7500, CR LF") << Kind{false, 7500, false, true, "\r\n"};
}

} // namespace

class TestFbxRewriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingChanged_data() { addKinds(); }
    void nothingChanged();
    void changedUvs_data() { addKinds(); }
    void changedUvs();
    void sharedUvs();
    void onlyTheChangedObject();
    void setsComeAndGo_data() { addKinds(); }
    void setsComeAndGo();
    void firstSet_data() { addKinds(); }
    void firstSet();
    void elementWithoutList();
    void everyMappingBecomesIndexed();
    void leftOutPolygonsKeepTheirUvs();
    void mirrored();
    void instances();
};

void TestFbxRewriter::nothingChanged()
{
    QFETCH(Kind, kind);
    const QByteArray bytes =
        fbxfiles::model(kind, {quadObject("a", {"one", "two"}), quadObject("b", {"two"})});
    Scene scene = parsed(bytes);
    QCOMPARE(written(scene), bytes);
    std::swap(scene.uvSets[0], scene.uvSets[1]); // another one is active
    QCOMPARE(written(scene), bytes);
}

void TestFbxRewriter::changedUvs()
{
    QFETCH(Kind, kind);
    const QByteArray bytes =
        fbxfiles::model(kind, {quadObject("a", {"one", "two"}), quadObject("b", {"two"})});
    Scene scene = parsed(bytes);
    scene.uvSets[1].uv = otherUv(*scene.mesh);
    scene.uvSets[1].uv.row(3).fill(noUv);
    const QByteArray out = written(scene);
    const Scene again = parsed(out);
    QCOMPARE(again.mesh->cornerVertex, scene.mesh->cornerVertex);
    QVERIFY(sameUv(again.uvSets[0].uv, scene.uvSets[0].uv));
    QVERIFY(sameUv(again.uvSets[1].uv, scene.uvSets[1].uv));
    QCOMPARE(unchanging(out), unchanging(bytes));
    QCOMPARE(elementsOf(out), (QStringList{u"0 one"_s, u"1 two"_s}));
    QCOMPARE(layersOf(out), u"0|1"_s);
    QCOMPARE(treeOf(out).version, kind.version);
    QCOMPARE(written(again), out);
    // And back: the values are those of the file again, though it may say them in another way.
    Scene back = again;
    back.uvSets[1].uv = parsed(bytes).uvSets[1].uv;
    QCOMPARE(unchanging(written(back)), unchanging(bytes));
    QVERIFY(sameUv(parsed(written(back)).uvSets[1].uv, back.uvSets[1].uv));
}

void TestFbxRewriter::sharedUvs()
{
    Scene scene = parsed(fbxfiles::model({}, {quadObject("a", {"one"})}));
    scene.uvSets[0].uv = otherUv(*scene.mesh);
    scene.uvSets[0].uv.row(7) << 5, 5; // a seam at one end of the edge
    scene.uvSets[0].uv.row(0).fill(noUv);
    const FbxTree tree = treeOf(written(scene));
    const int element = tree.child(tree.child(tree.child(0, "Objects"), "Geometry"), "LayerElementUV");
    QCOMPARE(tree.integers(tree.child(element, "UVIndex")).value(),
             (std::vector<int>{-1, 0, 1, 2, 0, 3, 4, 5}));
    QCOMPARE(tree.doubles(tree.child(element, "UV")).value().size(), std::size_t(12));
}

void TestFbxRewriter::onlyTheChangedObject()
{
    const QByteArray bytes =
        fbxfiles::model({false, 7400}, {quadObject("a", {"one"}), quadObject("b", {"one"})});
    Scene scene = parsed(bytes);
    scene.uvSets[0].uv.row(15) << 3, 3;
    const QByteArray out = written(scene);
    const qsizetype second = bytes.indexOf("Geometry:", bytes.indexOf("Geometry:") + 1);
    QCOMPARE(out.left(second), bytes.left(second));
    QVERIFY(out != bytes);
}

void TestFbxRewriter::setsComeAndGo()
{
    QFETCH(Kind, kind);
    const QByteArray bytes =
        fbxfiles::model(kind, {quadObject("a", {"one", "two"}), quadObject("b", {"two"})});
    const Scene scene = parsed(bytes);
    const auto check = [&](const std::vector<UvSet> &sets, const QStringList &elements,
                           const QString &layers) {
        Scene changed = scene;
        changed.uvSets = sets;
        const QByteArray out = written(changed);
        QCOMPARE(elementsOf(out), elements);
        QCOMPARE(layersOf(out), layers);
        const Scene again = parsed(out);
        for (const UvSet &set : sets) {
            const auto found = std::ranges::find(again.uvSets, set.name, &UvSet::name);
            QVERIFY(found != again.uvSets.end());
            QVERIFY(sameUv(found->uv, set.uv));
        }
        QCOMPARE(again.uvSets.size(), sets.size());
    };
    const UvSet &one = scene.uvSets[0];
    const UvSet &two = scene.uvSets[1];
    const UvSet added{u"third \"set\""_s, otherUv(*scene.mesh)};
    const QString third = kind.binary ? u"2 third \"set\""_s : u"2 third &quot;set&quot;"_s;
    check({added, one, two}, {u"0 one"_s, u"1 two"_s, third}, u"0|1|2"_s);
    check({{u"renamed"_s, one.uv}, two}, {u"0 renamed"_s, u"1 two"_s}, u"0|1"_s);
    check({two}, {u"0 two"_s}, u"|0"_s);
    check({one}, {u"0 one"_s}, u"0|"_s);
    check({{u"new"_s, added.uv}}, {u"0 new"_s}, u"0|"_s);
    UvSet partial = one;
    partial.uv.bottomRows(8) = added.uv.bottomRows(8); // the second object has no such set
    check({partial, two}, {u"0 one"_s, u"1 two"_s}, u"0|1"_s);
}

void TestFbxRewriter::firstSet()
{
    QFETCH(Kind, kind);
    for (const bool hasLayer : {true, false}) {
        Object object = quadObject("a", {});
        if (!hasLayer)
            object.mesh.pop_back();
        const QByteArray bytes = fbxfiles::model(kind, {object});
        Scene scene = parsed(bytes);
        QVERIFY(scene.uvSets.empty());
        scene.uvSets = {{u"UVMap"_s, otherUv(*scene.mesh)}};
        const QByteArray out = written(scene);
        QCOMPARE(elementsOf(out), QStringList{u"0 UVMap"_s});
        QCOMPARE(layersOf(out), u"0"_s);
        QVERIFY(sameUv(parsed(out).uvSets.at(0).uv, scene.uvSets[0].uv));
        if (hasLayer)
            QCOMPARE(unchanging(out), unchanging(bytes));
        // Taken out again, the file is as it was.
        Scene again = parsed(out);
        again.uvSets.clear();
        if (hasLayer)
            QCOMPARE(written(again), bytes);
    }
}

//! An element without a list is written as a whole. Its number follows those that were taken out before it.
void TestFbxRewriter::elementWithoutList()
{
    QByteArray bytes = fbxfiles::model(
        {false, 6100}, {{"a", fbxfiles::quads({fbxfiles::uvElement(1, "one"), fbxfiles::uvElement(0, "two"),
                                               fbxfiles::layer(0, {1}), fbxfiles::layer(1, {0})})}});
    const qsizetype begin = bytes.indexOf(" {", bytes.indexOf("LayerElementUV: 1"));
    bytes.remove(begin, bytes.indexOf("}", begin) + 1 - begin);
    QCOMPARE(elementsOf(bytes), (QStringList{u"1 "_s, u"0 two"_s}));
    Scene scene = parsed(bytes);
    scene.uvSets = {{u"new"_s, otherUv(*scene.mesh)}};
    const QByteArray out = written(scene);
    QCOMPARE(elementsOf(out), QStringList{u"0 new"_s});
    QCOMPARE(layersOf(out), u"0|"_s);
    QVERIFY(sameUv(parsed(out).uvSets.at(0).uv, scene.uvSets[0].uv));
}

void TestFbxRewriter::everyMappingBecomesIndexed()
{
    const std::vector<double> six{0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0};
    const std::vector<double> eight{0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0};
    for (const Kind &kind : {Kind{true, 7400}, Kind{false, 7400}, Kind{false, 6100}}) {
        for (const char *mapping : {"ByPolygonVertex", "ByVertice", "AllSame", "ByEdge"}) {
            const bool corner = qstrcmp(mapping, "ByPolygonVertex") == 0;
            const Node element = fbxfiles::layerElement("LayerElementUV", 0, "map", mapping, "Direct",
                                                        {{"UV", {corner ? eight : six}, {}}});
            const QByteArray bytes =
                fbxfiles::model(kind, {{"a", fbxfiles::quads({element, fbxfiles::layer(0, {0})})}});
            Scene scene = parsed(bytes);
            QCOMPARE(written(scene), bytes);
            scene.uvSets[0].uv = otherUv(*scene.mesh);
            const QByteArray out = written(scene);
            QVERIFY(sameUv(parsed(out).uvSets[0].uv, scene.uvSets[0].uv));
            QCOMPARE(unchanging(out), unchanging(bytes));
            QVERIFY(out.contains("IndexToDirect"));
        }
    }
}

void TestFbxRewriter::leftOutPolygonsKeepTheirUvs()
{
    const std::vector<std::int32_t> corners{0, -2, 0, 1, -3, 5, 1, -3, 0};
    const std::vector<double> points{0, 0, 0, 1, 0, 0, 1, 1, 0};
    const std::vector<double> uv{0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0, 8, 0};
    const Node element =
        fbxfiles::layerElement("LayerElementUV", 0, "map", "ByPolygonVertex", "Direct", {{"UV", {uv}, {}}});
    Scene scene = parsed(fbxfiles::model(
        {}, {{"a", {{"Vertices", {points}, {}}, {"PolygonVertexIndex", {corners}, {}}, element}}}));
    QCOMPARE(scene.mesh->faceCount(), 1);
    scene.uvSets[0].uv.row(1) << 9, 9;
    const FbxTree tree = treeOf(written(scene));
    const int now = tree.child(tree.child(tree.child(0, "Objects"), "Geometry"), "LayerElementUV");
    const std::vector<double> values = tree.doubles(tree.child(now, "UV")).value();
    const std::vector<int> index = tree.integers(tree.child(now, "UVIndex")).value();
    std::vector<double> u;
    for (const int i : index)
        u.push_back(values[static_cast<std::size_t>(2 * i)]);
    QCOMPARE(u, (std::vector<double>{0, 1, 2, 9, 4, 5, 6, 7, 8}));
}

void TestFbxRewriter::mirrored()
{
    Object object = quadObject("a", {"one"});
    object.properties = {fbxfiles::property({}, "Lcl Scaling", {-1, 1, 1})};
    const QByteArray bytes = fbxfiles::model({}, {object});
    Scene scene = parsed(bytes);
    QCOMPARE(written(scene), bytes);
    scene.uvSets[0].uv = otherUv(*scene.mesh, 0.5);
    QVERIFY(sameUv(parsed(written(scene)).uvSets[0].uv, scene.uvSets[0].uv));
}

void TestFbxRewriter::instances()
{
    Object second{"second", {}};
    second.properties = {fbxfiles::property({}, "Lcl Scaling", {1, -1, 1})};
    const QByteArray bytes = fbxfiles::model({}, {quadObject("first", {"one"}), second});
    Scene scene = parsed(bytes);
    QVERIFY(exportLosses(scene, u"fbx"_s).isEmpty());
    // The second one is changed, and then both have its map.
    scene.uvSets[0].uv.row(8) << 7, 7;
    QVERIFY(exportLosses(scene, u"fbx"_s).join(u' ').contains(u"share a mesh"_s));
    Scene again = parsed(written(scene));
    QVERIFY(sameUv(again.uvSets[0].uv.bottomRows(8), scene.uvSets[0].uv.bottomRows(8)));
    QCOMPARE(again.uvSets[0].uv(3, 0), 7.0);
    QVERIFY(exportLosses(again, u"fbx"_s).isEmpty());
    // Both are changed: the first one is written.
    scene.uvSets[0].uv.row(0) << 6, 6;
    again = parsed(written(scene));
    QVERIFY(sameUv(again.uvSets[0].uv.topRows(8), scene.uvSets[0].uv.topRows(8)));
}

QTEST_APPLESS_MAIN(TestFbxRewriter)

} // namespace tst_fbxrewriter

#include "tst_fbxrewriter.moc"
