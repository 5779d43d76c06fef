/* Large static tables: CRC remainders, ROM fonts, a maze; and big zeroed arrays. */
#include <stdio.h>

static const unsigned char font[3][5] = {
    { 0x0e, 0x11, 0x11, 0x11, 0x0e }, { 0x04, 0x0c, 0x04, 0x04, 0x0e }, { 0x1e, 0x01, 0x0e, 0x10, 0x1f },
};
static const char *const maze[] = {
    "##########", "#S.#.....#", "#.#..##.##", "#...#..#.#", "##.##.##.#", "#......#E#", "##########",
};
static int distance[7][10];
static double zeros[5000];
static const int primes[] = { 2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67,
                              71, 73, 79, 83, 89, 97, };

int main(void)
{
    int i, j, k, changed = 1;

    for (i = 0; i < 5; i++) {
        for (j = 0; j < 3; j++)
            for (k = 4; k >= 0; k--)
                putchar(font[j][i] >> k & 1 ? '#' : ' ');
        putchar('\n');
    }
    distance[1][1] = 1;
    while (changed) {
        changed = 0;
        for (i = 1; i < 6; i++)
            for (j = 1; j < 9; j++) {
                int best = distance[i][j];
                int near[4] = { distance[i - 1][j], distance[i + 1][j], distance[i][j - 1],
                                distance[i][j + 1] };
                if (maze[i][j] == '#')
                    continue;
                for (k = 0; k < 4; k++)
                    if (near[k] && (!best || near[k] + 1 < best))
                        best = near[k] + 1;
                if (best != distance[i][j])
                    distance[i][j] = best, changed = 1;
            }
    }
    for (i = 0; i < 7; i++, putchar('\n'))
        for (j = 0; j < 10; j++)
            printf("%3d", distance[i][j]);
    zeros[4999] += primes[24];
    printf("%g %g %d\n", zeros[0], zeros[4999], (int) (sizeof primes / sizeof *primes));
    return 0;
}
