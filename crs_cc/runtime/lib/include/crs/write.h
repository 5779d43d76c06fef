/* Output past all buffers, for the library itself. */
#ifndef CRS_WRITE_H
#define CRS_WRITE_H

/* Writes all bytes to a stream of the host; returns 0, or -1 with errno. */
int __crs_write(int descriptor, const void *bytes, int size);

/* Writes two strings, one after the other, to the standard error stream. */
void __crs_complain(const char *first, const char *second);

#endif
