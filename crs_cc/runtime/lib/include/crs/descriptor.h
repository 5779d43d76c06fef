/* Descriptors: the standard streams and open files by small numbers, for the library itself. Each
   function returns what its POSIX namesake does, -1 with errno on error. */
#ifndef CRS_DESCRIPTOR_H
#define CRS_DESCRIPTOR_H

#define CRS_DESCRIPTORS 64

struct __crs_open_file;

/* What is done with something open that is no file. Each function but the last returns what its
   POSIX namesake does, -1 with errno on error. */
struct __crs_operations {
    int (*read)(struct __crs_open_file *file, void *bytes, int size);
    int (*write)(struct __crs_open_file *file, const void *bytes, int size);
    int (*close)(struct __crs_open_file *file);
    int (*available)(struct __crs_open_file *file);   /* bytes to be read at once */
    int (*poll)(struct __crs_open_file *file);        /* bits of poll.h */

    /* Waits until one may be ready or the time is over; -1 after a signal. */
    int (*wait)(const int *wanted, int count, double wait_s);
};

/* For `wait`: 4 times the host's number, and what is waited for. */
#define CRS_RECEIVES 1
#define CRS_SENDS 2

/* An open file, which several descriptors may share. */
struct __crs_open_file {
    int uses;       /* number of descriptors that refer to it */
    int flags;      /* as passed to open */
    int number;     /* the host's number of the file; -1 for a standard stream */
    long offset;    /* where to read or write next; of a standard stream: its number */
    const struct __crs_operations *operations;   /* null for a file */
};

/* Returns the open file of a descriptor; null with errno EBADF if it is not open. */
struct __crs_open_file *__crs_find(int descriptor);

/* Opens something that is no file; returns its descriptor. */
int __crs_install(const struct __crs_operations *operations, int number, int flags);

int __crs_open(const char *name, int flags);
int __crs_close(int descriptor);
int __crs_duplicate(int descriptor, int wanted);   /* the lowest free one from `wanted` on */
long __crs_seek(int descriptor, long offset, int whence);
long __crs_resize(int descriptor, long size);      /* -1 changes nothing; returns the size */

/* Reads the available bytes, at most one message; returns 0 at end of file. */
int __crs_read(int descriptor, void *bytes, int size);

/* Writes all bytes; returns 0. */
int __crs_put(int descriptor, const void *bytes, int size);

/* Posts a request about a name; returns the reply's result, -1 with errno on error. */
int __crs_by_name(int code, const char *name, int argument);

/* Returns how many bytes of the standard input can be read; sets how long a read waits [s],
   infinite if that is not known. */
int __crs_input(double *wait_s);

#endif
