/* What the kernels share: their arrays lie in one arena, which numpy writes and reads. */
#ifndef CRS_KERNELS_H
#define CRS_KERNELS_H

#define BLOCK 0x20000               /* elements of an array; complex numbers are two doubles each */

/* Elementwise functions, see functions.c. */
void __crs_apply(int function, int count, double *a, double *b, double *out);

/* The first echo of each of some pings, see echoes.c. The tables of shapes are overwritten. */
void __crs_echoes(int count, int hushed, const double *pings, double *faces, double *rounds,
                  const double *voices, double *out);

#endif
