/* Autocuts for programs: makes, packs and measures UV maps of polygon meshes. C interface; autocuts.hpp wraps
 * it for C++.
 *
 * Meshes go in as arrays and stay the caller's; nothing of them is kept after a call. UVs come out per corner
 * (one for each entry of `indices`), with the lower left of the texture at (0, 0) and the upper right at (1,
 * 1); UDIM tiles beside it continue these coordinates. The same mesh and options give the same bits on any
 * number of threads, and the same as `autocuts-cli`.
 *
 * Thread-safe: calls may run at the same time, each with its number of threads. Nothing is printed. The
 * licence is GPL-3.0-or-later: so must be what is linked with it and distributed.
 */
#ifndef AUTOCUTS_H
#define AUTOCUTS_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define AUTOCUTS_API __attribute__((visibility("default")))
#else
#define AUTOCUTS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* "0.2.0", the version of the library that is loaded. */
AUTOCUTS_API const char *autocuts_version(void);

/* How a call ended. */
typedef enum autocuts_status {
    AUTOCUTS_OK = 0,
    AUTOCUTS_STOPPED = 1,   /* by the callback, before there was a map */
    AUTOCUTS_BAD_INPUT = 2, /* the mesh or an option cannot be used */
    AUTOCUTS_NO_ROOM = 3,   /* the margins leave no room for the islands */
    AUTOCUTS_NO_MEMORY = 4,
    AUTOCUTS_FAILED = 5 /* a fault of the library */
} autocuts_status;

/* What went wrong, and what to do. Texts are UTF-8 and end with 0. */
typedef struct autocuts_error
{
    char message[256];
    char remedy[128]; /* may be empty */
} autocuts_error;

/* A corner that is held at a place in the map. */
typedef struct autocuts_pin
{
    size_t corner;
    double u, v;
    double weight; /* of the spring that pulls the corner there; 0: held exactly */
} autocuts_pin;

/* A polygon mesh, and what is wished of its map. Fill it with 0 first: what is NULL is not given. "Per
 * corner" means one entry for each of `indices`; an entry for an edge is that of the corner at which it
 * begins, and the edge ends at the next corner of the face. */
typedef struct autocuts_mesh
{
    const double *positions; /* x, y, z of each vertex; finite, at most 1e150 */
    size_t vertex_count;
    const uint32_t *face_sizes; /* corners of each face, at least 3; NULL: all faces are triangles */
    size_t face_count;
    const uint32_t *indices;       /* the vertex of each corner, face by face */
    const int32_t *face_objects;   /* from 0: seams run between objects; NULL: one object */
    const int32_t *face_materials; /* from 0, -1 for none; NULL: none has one */
    const double *normals; /* x, y, z of each corner. An edge at which those of its faces differ is hard; (0,
                              0, 0) where there is none */
    const double *colors;  /* red, green, blue of each corner, linear, 0 to 1; for bakes */
    const double *uvs;     /* u, v of each corner, NaN where there is none; NULL: no map yet */
    const uint8_t *locked_faces; /* not 0: the island of this face stays as it is in `uvs` */
    /* An autocuts_edge for each edge. What its two faces say counts together, a seam more than a join. NULL:
     * all edges are free. */
    const uint8_t *edges;
    /* For each edge a factor on what a seam along it costs, at least 0; the mean of what its two faces say.
     */
    const double *edge_weights;
    const double
        *texel_weights; /* per face, .125 to 8: how much more texels per length it gets than others */
    const autocuts_pin *pins;
    size_t pin_count;
} autocuts_mesh;

typedef enum autocuts_edge {
    AUTOCUTS_EDGE_FREE = 0,
    AUTOCUTS_EDGE_SEAM = 1,  /* always a seam */
    AUTOCUTS_EDGE_JOINED = 2 /* no seam, as far as there is a map without overlaps for that */
} autocuts_edge;

typedef enum autocuts_quality {
    AUTOCUTS_DRAFT = 0,
    AUTOCUTS_STANDARD = 1,
    AUTOCUTS_BEST = 2
} autocuts_quality;

typedef enum autocuts_surface {
    AUTOCUTS_SURFACE_AUTO = 0,    /* each part of the mesh is recognised */
    AUTOCUTS_SURFACE_ORGANIC = 1, /* stretch may go anywhere */
    AUTOCUTS_SURFACE_HARD = 2     /* flat faces keep their shape, sharp edges get the seams */
} autocuts_surface;

typedef enum autocuts_switch {
    AUTOCUTS_OFF = 0,
    AUTOCUTS_AUTO = 1, /* on parts that are hard surfaces */
    AUTOCUTS_ON = 2
} autocuts_switch;

/* Whether both sides of a symmetric mesh get the same seams. */
typedef enum autocuts_symmetry {
    AUTOCUTS_SYMMETRY_OFF = 0,
    AUTOCUTS_SYMMETRY_ON = 1,  /* on every symmetric mesh */
    AUTOCUTS_SYMMETRY_AUTO = 2 /* where they hardly cost more */
} autocuts_symmetry;

/* How connected parts that are copies of each other are treated. */
typedef enum autocuts_alike {
    AUTOCUTS_ALIKE_OFF = 0,
    AUTOCUTS_ALIKE_SAME_CUTS = 1,
    AUTOCUTS_ALIKE_STACK = 2 /* the same cuts, and their islands lie on each other */
} autocuts_alike;

/* Which edges may become seams: any; the given seams stay, and those are added that the bound needs; the
 * given seams and no others. */
typedef enum autocuts_seams {
    AUTOCUTS_SEAMS_FREE = 0,
    AUTOCUTS_SEAMS_KEEP = 1,
    AUTOCUTS_SEAMS_ONLY = 2
} autocuts_seams;

/* Which edges are given seams: values to be added up. */
typedef enum autocuts_seam_source {
    AUTOCUTS_SEAMS_FROM_EDGES = 1,     /* AUTOCUTS_EDGE_SEAM of the mesh */
    AUTOCUTS_SEAMS_FROM_UVS = 2,       /* the seams of the map that is there */
    AUTOCUTS_SEAMS_FROM_SHARP = 4,     /* edges bent by more than sharp_angle */
    AUTOCUTS_SEAMS_FROM_HARD = 8,      /* edges at which normals differ */
    AUTOCUTS_SEAMS_FROM_MATERIALS = 16 /* edges between two materials */
} autocuts_seam_source;

typedef enum autocuts_axis {
    AUTOCUTS_AXIS_NONE = 0,
    AUTOCUTS_AXIS_Y = 1,
    AUTOCUTS_AXIS_Z = 2,
    AUTOCUTS_AXIS_AUTO_Y = 3, /* where that costs at most 5 % of the texel density */
    AUTOCUTS_AXIS_AUTO_Z = 4
} autocuts_axis;

/* How packing may turn islands: not at all, freely, or by multiples of so many degrees. */
typedef enum autocuts_rotation {
    AUTOCUTS_ROTATION_NONE = 0,
    AUTOCUTS_ROTATION_FREE = 1,
    AUTOCUTS_ROTATION_15 = 15,
    AUTOCUTS_ROTATION_30 = 30,
    AUTOCUTS_ROTATION_45 = 45,
    AUTOCUTS_ROTATION_90 = 90,
    AUTOCUTS_ROTATION_180 = 180
} autocuts_rotation;

/* Receives progress, a share from 0 to 1, from one thread at a time; not 0: stop soon, with the best map so
 * far. */
typedef int (*autocuts_progress)(double fraction, void *user);

/* A map of a mesh. */
typedef struct autocuts_map autocuts_map;

/* Receives a map, to be freed by autocuts_map_free(). */
typedef void (*autocuts_take_map)(autocuts_map *map, void *user);

/* To be filled by autocuts_options_init() first. Names and defaults are those of autocuts-cli. */
typedef struct autocuts_options
{
    size_t size;            /* of this struct, so that later versions can add to it */
    int quality;            /* autocuts_quality */
    double max_distortion;  /* bound on the mean symmetric Dirichlet energy, above 4, which is a map without
                               stretch */
    int seams;              /* autocuts_seams */
    unsigned seams_from;    /* of autocuts_seam_source */
    double sharp_angle;     /* degrees */
    int surface;            /* autocuts_surface: what the model is like */
    int flat_rigid;         /* not 0: flat faces, and what unrolls without stretch, keep their shape */
    int alike;              /* autocuts_alike */
    int creases;            /* autocuts_switch: seams along sharp edges */
    double crease_strength; /* part of its cost that a seam on a sharp edge saves, 0 to 1 */
    double visibility;      /* how much seams prefer hidden places, 0 to 1 */
    int symmetry;           /* autocuts_symmetry: the same seams on both sides of symmetric meshes */
    int mirror;             /* not 0: islands of both sides get maps that are mirror images */
    int align;              /* autocuts_switch: islands run along the axes, straight edges stay straight */
    int world_up;           /* autocuts_axis: the direction of the model that is up in the map */
    int texture_width, texture_height; /* texels */
    double margin;                     /* texels between islands */
    double tile_border;                /* texels to the border of the texture; below 0: half the margin */
    int rotation;                      /* autocuts_rotation */
    int keep_scale;                    /* packing: not 0: islands keep their size */
    double pack_time; /* CPU seconds that packing may take, counted as work and not by a clock */
    /* Texels per unit of the mesh: islands get it, in as many UDIM tiles as that needs. 0: they fill one
     * tile. */
    double density;
    int threads;                /* at least 1 */
    autocuts_progress progress; /* may be NULL */
    void *user;                 /* for progress */
    /* Receives each better map while autocuts_unwrap() searches, packed into one tile with little effort. It
     * is called on a thread of its own, never two at a time and not after the end of the call. It has no
     * effect on the result. May be NULL. */
    autocuts_take_map better;
    void *better_user; /* for better */
} autocuts_options;

AUTOCUTS_API void autocuts_options_init(autocuts_options *options);

/* Cuts, maps and packs. After a stop, the map is the best one so far. On AUTOCUTS_OK, *map is to be freed by
 * autocuts_map_free(); otherwise it is NULL and *error says why. error may be NULL. This holds for all
 * functions that make a map. */
AUTOCUTS_API autocuts_status autocuts_unwrap(const autocuts_mesh *mesh, const autocuts_options *options,
                                             autocuts_map **map, autocuts_error *error);
/* Makes the map mesh->uvs usable: within the bound, with few seams, no overlaps, packed where it has to be.
 */
AUTOCUTS_API autocuts_status autocuts_finish(const autocuts_mesh *mesh, const autocuts_options *options,
                                             autocuts_map **map, autocuts_error *error);
/* Packs the islands of mesh->uvs. With AUTOCUTS_ALIKE_STACK, those that are copies are laid on each other. */
AUTOCUTS_API autocuts_status autocuts_pack(const autocuts_mesh *mesh, const autocuts_options *options,
                                           autocuts_map **map, autocuts_error *error);
/* Cuts the islands of mesh->uvs that overlap themselves, and packs. */
AUTOCUTS_API autocuts_status autocuts_separate(const autocuts_mesh *mesh, const autocuts_options *options,
                                               autocuts_map **map, autocuts_error *error);
/* Turns the islands of mesh->uvs to the axes and makes straight what is straight on the mesh, as far as the
 * bound allows. Seams and sizes stay. */
AUTOCUTS_API autocuts_status autocuts_align(const autocuts_mesh *mesh, const autocuts_options *options,
                                            autocuts_map **map, autocuts_error *error);
/* Makes a map for light maps of mesh->uvs: no overlaps, one texel density, stacks taken apart. */
AUTOCUTS_API autocuts_status autocuts_lightmap(const autocuts_mesh *mesh, const autocuts_options *options,
                                               autocuts_map **map, autocuts_error *error);
/* mesh->uvs as a map, to be measured or drawn. */
AUTOCUTS_API autocuts_status autocuts_take(const autocuts_mesh *mesh, const autocuts_options *options,
                                           autocuts_map **map, autocuts_error *error);

/* How faces find their UVs. */
typedef enum autocuts_match {
    AUTOCUTS_MATCH_AUTO = 0,     /* copied where the polygons are the same, otherwise by position */
    AUTOCUTS_MATCH_TOPOLOGY = 1, /* the same polygons in the same order, or at the same positions */
    AUTOCUTS_MATCH_POSITION = 2  /* the nearest points of the surface */
} autocuts_match;

typedef struct autocuts_transferred
{
    int64_t faces;        /* that were to get UVs */
    int64_t copied;       /* that have those of an equal face */
    int64_t placed;       /* that have theirs by position */
    double mean_distance; /* of the faces that were placed, in the units of the source */
    double scale;         /* of the source, where it has other units than the mesh: 1 where not */
} autocuts_transferred;

/* Gives the mesh the UVs of another one, also of another resolution. Faces that find none have NaN, or what
 * mesh->uvs has. transferred may be NULL. */
AUTOCUTS_API autocuts_status autocuts_transfer(const autocuts_mesh *source, const autocuts_mesh *mesh,
                                               autocuts_match match, const autocuts_options *options,
                                               autocuts_map **map, autocuts_transferred *transferred,
                                               autocuts_error *error);

AUTOCUTS_API void autocuts_map_free(autocuts_map *map);

AUTOCUTS_API size_t autocuts_map_corner_count(const autocuts_map *map);
AUTOCUTS_API size_t autocuts_map_face_count(const autocuts_map *map);
AUTOCUTS_API size_t autocuts_map_island_count(const autocuts_map *map);
/* u, v of each corner; NaN where there is none. The arrays live as long as the map. */
AUTOCUTS_API const double *autocuts_map_uvs(const autocuts_map *map);
/* The island of each face, from 0; -1 without UVs. */
AUTOCUTS_API const int32_t *autocuts_map_islands(const autocuts_map *map);
/* Per corner: 1 when the edge from it to the next corner of its face is a seam or a border of the mesh, else
 * 0. */
AUTOCUTS_API const uint8_t *autocuts_map_seams(const autocuts_map *map);

/* How the job of a map went. */
typedef struct autocuts_outcome
{
    int stopped;           /* 1: it was stopped early */
    int within_bound;      /* 0: the bound on the distortion was not met */
    double hard_share;     /* share of the area in parts that count as hard surfaces */
    int64_t unmet_pins;    /* pins that are held exactly and that the map does not obey */
    int64_t unmet_joins;   /* edges that should not be seams and are */
    int64_t missing_seams; /* further seams without which a map from given seams only is not possible */
} autocuts_outcome;

AUTOCUTS_API autocuts_outcome autocuts_map_outcome(const autocuts_map *map);

/* Figures of a map, as in the reports of autocuts-cli. What could not be measured is NaN. */
typedef struct autocuts_figures
{
    double distortion;         /* mean symmetric Dirichlet energy; 4: no stretch */
    double seam_norm;          /* length of the seams, of a mesh with area pi */
    double packing_efficiency; /* part of the tiles in use that islands take */
    double gutter_texels;      /* smallest distance between islands */
    int64_t islands, flipped_triangles, overlapping_pairs;
} autocuts_figures;

AUTOCUTS_API autocuts_status autocuts_measure(const autocuts_map *map, autocuts_figures *figures,
                                              autocuts_error *error);

/* Draws a map: each island in a colour of its own, seams darker, overlaps red, the rest transparent. Rows run
 * from the top of the tile. \param tile UDIM number, 1001 is the first one \param rgba height x width x 4
 * bytes */
AUTOCUTS_API autocuts_status autocuts_draw(const autocuts_map *map, int tile, int width, int height,
                                           uint8_t *rgba, autocuts_error *error);

/* A map that gets better all the time on a thread of its own, and follows its steering. */
typedef struct autocuts_live autocuts_live;

/* Starts with mesh->uvs, or with no map. The callback of the options is not used. On AUTOCUTS_OK, *live is to
 * be ended by autocuts_live_free(). */
AUTOCUTS_API autocuts_status autocuts_live_start(const autocuts_mesh *mesh, const autocuts_options *options,
                                                 autocuts_live **live, autocuts_error *error);
/* Takes other pins, edges, weights, locks or options for the same vertices and faces. Locked faces keep what
 * they have in mesh->uvs, if it is given. */
AUTOCUTS_API autocuts_status autocuts_live_steer(autocuts_live *live, const autocuts_mesh *mesh,
                                                 const autocuts_options *options, autocuts_error *error);
/* Waits until there is a map that was not given out yet. *map is NULL when none came in time, or when nothing
 * is left to gain. */
AUTOCUTS_API autocuts_status autocuts_live_wait(autocuts_live *live, double seconds, autocuts_map **map,
                                                autocuts_error *error);
/* 1 when nothing is left to gain: new steering sets it to work again. */
AUTOCUTS_API int autocuts_live_rests(const autocuts_live *live);
AUTOCUTS_API void autocuts_live_free(autocuts_live *live);

/* What is baked. */
typedef enum autocuts_bake_map {
    AUTOCUTS_BAKE_NORMAL = 0,        /* tangent space, MikkTSpace; 3 channels */
    AUTOCUTS_BAKE_OBJECT_NORMAL = 1, /* 3 channels */
    AUTOCUTS_BAKE_OCCLUSION = 2,
    AUTOCUTS_BAKE_BENT_NORMAL = 3, /* 3 channels */
    AUTOCUTS_BAKE_CURVATURE = 4,
    AUTOCUTS_BAKE_THICKNESS = 5,
    AUTOCUTS_BAKE_POSITION = 6,    /* 3 channels */
    AUTOCUTS_BAKE_COLOR = 7,       /* of autocuts_mesh.colors; 3 channels */
    AUTOCUTS_BAKE_MATERIAL_ID = 8, /* a colour for each material; 3 channels */
    AUTOCUTS_BAKE_HEIGHT = 9
} autocuts_bake_map;

/* How rays leave the surface. */
typedef enum autocuts_cage_direction {
    AUTOCUTS_CAGE_SMOOTH = 0,   /* along normals that are smooth over all edges */
    AUTOCUTS_CAGE_SHADING = 1,  /* along the shading normals */
    AUTOCUTS_CAGE_CORRECTED = 2 /* smooth beside edges, straight elsewhere */
} autocuts_cage_direction;

/* To be filled by autocuts_bake_options_init() first. Distances are shares of the diagonal of the mesh's
 * bounding box. Names and defaults are those of autocuts-cli. */
typedef struct autocuts_bake_options
{
    size_t size;       /* of this struct */
    int width, height; /* texels of the pictures */
    int tile;          /* UDIM tile that is baked: 1001 is the first one */
    int samples;       /* along each side of a texel, 1 to 8 */
    int rays;          /* per texel */
    double cage;       /* how far the detailed mesh is looked for; below 0: measured */
    const double
        *cage_positions; /* in its place: x, y, z of each vertex of the mesh, moved outwards; or NULL */
    int cage_direction;  /* autocuts_cage_direction */
    double ray_reach;    /* what is farther away does not occlude; 0: everything does */
    double curvature_radius, thickness_limit;
    int dilation; /* texels around islands that are filled */
    int directx;  /* not 0: normals with green down */
    int floats;   /* not 0: positions and heights in the units of the mesh; 0: all numbers from 0 to 1 */
    int threads;
    autocuts_progress progress; /* not 0 from it ends the bake: AUTOCUTS_STOPPED */
    void *user;
} autocuts_bake_options;

AUTOCUTS_API void autocuts_bake_options_init(autocuts_bake_options *options);

/* Texels inside of islands; of them, those of which no ray met the detailed mesh. */
typedef struct autocuts_baked
{
    int64_t texels, missed;
} autocuts_baked;

/* Channels of a picture: 1 or 3; 0 when there is no such map. */
AUTOCUTS_API int autocuts_bake_channels(int map);
/* Bakes into the map mesh->uvs. \param high the detailed mesh, at the same place; NULL: the mesh itself
 * \param maps of autocuts_bake_map \param pictures for each of them, height x width x channels numbers; rows
 * run from the top \param baked may be NULL */
AUTOCUTS_API autocuts_status autocuts_bake(const autocuts_mesh *mesh, const autocuts_mesh *high,
                                           const autocuts_bake_options *options, const int *maps,
                                           size_t map_count, float *const *pictures, autocuts_baked *baked,
                                           autocuts_error *error);

#ifdef __cplusplus
}
#endif

#endif
