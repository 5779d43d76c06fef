/* Memory of variable-length arrays, and of alloca. The compiler generates the calls. */
#ifndef _CRS_AUTOMATIC_H
#define _CRS_AUTOMATIC_H

/* The number of blocks allocated; they are freed in the opposite order. */
extern int __crs_automatic_count;

/* Allocates memory for a variable; stops the program if the heap is exhausted. */
void *__crs_automatic(unsigned size, const char *name);

/* Frees all but the first `count` blocks. */
void __crs_release(int count);

#endif
