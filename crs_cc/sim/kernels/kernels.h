/* What the kernels share: their arrays lie in one arena, which numpy writes and reads. */
#ifndef CRS_KERNELS_H
#define CRS_KERNELS_H

#define BLOCK 0x20000               /* elements of an array; complex numbers are two doubles each */

/* Elementwise functions, see functions.c. */
void __crs_apply(int function, int count, const double *a, const double *b, double *out);

#endif
