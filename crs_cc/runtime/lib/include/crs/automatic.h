/* Memory of arrays whose length is not constant, and of alloca. The compiler makes the calls. */
#ifndef _CRS_AUTOMATIC_H
#define _CRS_AUTOMATIC_H

/* How many pieces of memory are given out; they are given back in the opposite order. */
extern int __crs_automatic_count;

/* Returns memory for the variable of a name; stops the program when there is none. */
void *__crs_automatic(unsigned size, const char *name);

/* Takes back all but the first `count` pieces. */
void __crs_release(int count);

#endif
