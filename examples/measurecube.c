/* Unwraps a cube from C and prints the figures of its map. */
#include <autocuts/autocuts.h>

#include <stdio.h>

int main(void)
{
    const double positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
    const uint32_t sizes[] = {4, 4, 4, 4, 4, 4};
    const uint32_t indices[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    const autocuts_mesh mesh = {positions, 8, sizes, 6, indices, NULL, NULL, NULL, NULL};
    autocuts_options options;
    autocuts_map *map;
    autocuts_figures figures;
    autocuts_error error;
    autocuts_options_init(&options);
    options.quality = AUTOCUTS_DRAFT;
    if (autocuts_unwrap(&mesh, &options, &map, &error) != AUTOCUTS_OK ||
        autocuts_measure(map, &figures, &error) != AUTOCUTS_OK) {
        fprintf(stderr, "%s. %s\n", error.message, error.remedy);
        return 1;
    }
    printf("islands %lld, distortion %g, flipped %lld\n", (long long)figures.islands, figures.distortion,
           (long long)figures.flipped_triangles);
    autocuts_map_free(map);
    return 0;
}
