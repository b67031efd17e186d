# Makes a UV map with the xatlas inside Godot 3 (Debian: godot3-server), for scripts/compare:
#   IN=model.obj OUT=map.obj godot3-server --script peer_xatlas.gd
# Prints "CPU seconds: X", of the charts, their maps and the packing alone. Polygons become fans. Texels: those that
# give the whole surface 1400 x 1400 of them.
extends SceneTree


func cpu_seconds():
    var stat = File.new()
    stat.open("/proc/self/stat", File.READ)
    var fields = stat.get_line().split(") ")[1].split(" ")
    return (int(fields[11]) + int(fields[12])) / 100.0


func _init():
    var points = PoolVector3Array()
    var corners = PoolIntArray()
    var file = File.new()
    if file.open(OS.get_environment("IN"), File.READ) != OK:
        print("cannot read ", OS.get_environment("IN"))
        quit(1)
        return
    while not file.eof_reached():
        var words = file.get_line().split(" ", false)
        if words.size() >= 4 and words[0] == "v":
            points.append(Vector3(float(words[1]), float(words[2]), float(words[3])))
        elif words.size() >= 4 and words[0] == "f":
            for k in range(2, words.size() - 1):
                for word in [words[1], words[k], words[k + 1]]:
                    corners.append(int(word.split("/")[0]) - 1)
    file.close()
    var normals = PoolVector3Array()
    normals.resize(points.size())
    var area = 0.0
    for t in range(0, corners.size(), 3):
        var a = points[corners[t]]
        var normal = (points[corners[t + 2]] - a).cross(points[corners[t + 1]] - a)
        area += normal.length() / 2
        for k in range(3):
            normals[corners[t + k]] += normal
    for i in range(points.size()):
        points[i] *= 1400 / sqrt(area) # xatlas leaves out what is tiny
        normals[i] = normals[i].normalized() if normals[i].length() > 0 else Vector3(0, 0, 1)
    var arrays = []
    arrays.resize(Mesh.ARRAY_MAX)
    arrays[Mesh.ARRAY_VERTEX] = points
    arrays[Mesh.ARRAY_NORMAL] = normals
    arrays[Mesh.ARRAY_INDEX] = corners
    var mesh = ArrayMesh.new()
    mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [], 0) # 0: not as half floats
    var before = cpu_seconds()
    var error = mesh.lightmap_unwrap(Transform(), 1.0)
    print("CPU seconds: ", cpu_seconds() - before)
    if error != OK:
        print("xatlas failed")
        quit(1)
        return
    arrays = mesh.surface_get_arrays(0)
    file.open(OS.get_environment("OUT"), File.WRITE)
    for point in arrays[Mesh.ARRAY_VERTEX]:
        file.store_line("v %.9f %.9f %.9f" % [point.x, point.y, point.z])
    for uv in arrays[Mesh.ARRAY_TEX_UV2]: # Godot's v points down
        file.store_line("vt %.9f %.9f" % [uv.x, 1 - uv.y])
    corners = arrays[Mesh.ARRAY_INDEX]
    for t in range(0, corners.size(), 3):
        var face = [corners[t] + 1, corners[t + 1] + 1, corners[t + 2] + 1]
        file.store_line("f %d/%d %d/%d %d/%d" % [face[0], face[0], face[1], face[1], face[2], face[2]])
    file.close()
    quit()
