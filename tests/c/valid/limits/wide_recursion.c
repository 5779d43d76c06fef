/* Recursion through a function that computes with many values at once. */
#include <stdio.h>

static int v[60];
static double d[60];

static double deeper(int n)
{
    int sum =
        v[0] * n + (v[1] * n + (v[2] * n + (v[3] * n + (v[4] * n + (v[5] * n + (v[6] * n
        + (v[7] * n + (v[8] * n + (v[9] * n + (v[10] * n + (v[11] * n + (v[12] * n +
        (v[13] * n + (v[14] * n + (v[15] * n + (v[16] * n + (v[17] * n + (v[18] * n +
        (v[19] * n + (v[20] * n + (v[21] * n + (v[22] * n + (v[23] * n + (v[24] * n +
        (v[25] * n + (v[26] * n + (v[27] * n + (v[28] * n + (v[29] * n + (v[30] * n +
        (v[31] * n + (v[32] * n + (v[33] * n + (v[34] * n + (v[35] * n + (v[36] * n +
        (v[37] * n + (v[38] * n + (v[39] * n + (v[40] * n + (v[41] * n + (v[42] * n +
        (v[43] * n + (v[44] * n + (v[45] * n + (v[46] * n + (v[47] * n + (v[48] * n +
        (v[49] * n + (v[50] * n + (v[51] * n + (v[52] * n + (v[53] * n + (v[54] * n +
        (v[55] * n + (v[56] * n + (v[57] * n + (v[58] * n + (v[59] *
        n)))))))))))))))))))))))))))))))))))))))))))))))))))))))))));
    double more =
        d[0] * n + (d[1] * n + (d[2] * n + (d[3] * n + (d[4] * n + (d[5] * n + (d[6] * n
        + (d[7] * n + (d[8] * n + (d[9] * n + (d[10] * n + (d[11] * n + (d[12] * n +
        (d[13] * n + (d[14] * n + (d[15] * n + (d[16] * n + (d[17] * n + (d[18] * n +
        (d[19] * n + (d[20] * n + (d[21] * n + (d[22] * n + (d[23] * n + (d[24] * n +
        (d[25] * n + (d[26] * n + (d[27] * n + (d[28] * n + (d[29] * n + (d[30] * n +
        (d[31] * n + (d[32] * n + (d[33] * n + (d[34] * n + (d[35] * n + (d[36] * n +
        (d[37] * n + (d[38] * n + (d[39] * n + (d[40] * n + (d[41] * n + (d[42] * n +
        (d[43] * n + (d[44] * n + (d[45] * n + (d[46] * n + (d[47] * n + (d[48] * n +
        (d[49] * n + (d[50] * n + (d[51] * n + (d[52] * n + (d[53] * n + (d[54] * n +
        (d[55] * n + (d[56] * n + (d[57] * n + (d[58] * n + (d[59] *
        n)))))))))))))))))))))))))))))))))))))))))))))))))))))))))));

    return n ? deeper(n - 1) + sum + more : 0;
}

int main(void)
{
    for (int i = 0; i < 60; i++) {
        v[i] = i;
        d[i] = i / 4.0;
    }
    printf("%.2f\n", deeper(1000));
    return 0;
}
