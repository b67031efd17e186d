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

/* "0.1.0", the version of the library that is loaded. */
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

/* A polygon mesh. */
typedef struct autocuts_mesh
{
    const double *positions; /* x, y, z of each vertex; finite, at most 1e150 */
    size_t vertex_count;
    const uint32_t *face_sizes; /* corners of each face, at least 3; NULL: all faces are triangles */
    size_t face_count;
    const uint32_t *indices;     /* the vertex of each corner, face by face */
    const int32_t *face_objects; /* from 0: seams run between objects; NULL: one object */
    const double *uvs;           /* u, v of each corner, NaN where there is none; NULL: no map yet */
    const uint8_t *locked_faces; /* not 0: the island of this face stays as it is in `uvs`; NULL: none */
    /* An autocuts_edge for the edge from each corner to the next one of its face. What its two faces say
     * counts together, a seam more than a join. NULL: all edges are free. */
    const uint8_t *edges;
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

/* Turns of islands that packing may make: none, right angles or any. */
typedef enum autocuts_rotation {
    AUTOCUTS_ROTATION_NONE = 0,
    AUTOCUTS_ROTATION_QUARTER = 1,
    AUTOCUTS_ROTATION_ANY = 2
} autocuts_rotation;

/* Receives progress, a share from 0 to 1, from one thread at a time; not 0: stop soon, with the best map so
 * far. */
typedef int (*autocuts_progress)(double fraction, void *user);

/* To be filled by autocuts_options_init() first. Names and defaults are those of autocuts-cli. */
typedef struct autocuts_options
{
    size_t size;           /* of this struct, so that later versions can add to it */
    int quality;           /* autocuts_quality */
    double max_distortion; /* bound on the mean symmetric Dirichlet energy, above 4, which is a map without
                              stretch */
    int surface;           /* autocuts_surface */
    int symmetry;          /* not 0: symmetric seams on symmetric meshes */
    int align;             /* not 0: islands run along the axes, straight edges stay straight */
    int texture_width, texture_height; /* texels */
    double margin;                     /* texels between islands */
    double border;                     /* texels to the border of the texture; below 0: half the margin */
    int rotation;                      /* autocuts_rotation */
    int keep_scale;                    /* packing: not 0: islands keep their size */
    double pack_effort; /* CPU seconds that packing may take, counted as work and not by a clock */
    /* Texels per unit of the mesh: islands get it, in as many UDIM tiles as that needs. 0: they fill one
     * tile. */
    double density;
    int threads;                /* at least 1 */
    autocuts_progress progress; /* may be NULL */
    void *user;                 /* for progress */
} autocuts_options;

AUTOCUTS_API void autocuts_options_init(autocuts_options *options);

/* A map of a mesh. */
typedef struct autocuts_map autocuts_map;

/* Cuts, maps and packs. After a stop, the map is the best one so far. On AUTOCUTS_OK, *map is to be freed by
 * autocuts_map_free(); otherwise it is NULL and *error says why. error may be NULL. */
AUTOCUTS_API autocuts_status autocuts_unwrap(const autocuts_mesh *mesh, const autocuts_options *options,
                                             autocuts_map **map, autocuts_error *error);
/* Packs the islands of mesh->uvs; of the options, quality, bound, surface, symmetry and align do not count.
 */
AUTOCUTS_API autocuts_status autocuts_pack(const autocuts_mesh *mesh, const autocuts_options *options,
                                           autocuts_map **map, autocuts_error *error);
/* Cuts the islands of mesh->uvs that overlap themselves, and packs. */
AUTOCUTS_API autocuts_status autocuts_separate(const autocuts_mesh *mesh, const autocuts_options *options,
                                               autocuts_map **map, autocuts_error *error);
/* mesh->uvs as a map, to be measured. */
AUTOCUTS_API autocuts_status autocuts_take(const autocuts_mesh *mesh, const autocuts_options *options,
                                           autocuts_map **map, autocuts_error *error);
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
/* 1 when the job was stopped early, else 0. */
AUTOCUTS_API int autocuts_map_stopped(const autocuts_map *map);

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

#ifdef __cplusplus
}
#endif

#endif
