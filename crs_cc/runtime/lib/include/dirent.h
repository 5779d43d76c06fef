/* POSIX dirent.h: the directories of the simulated disk. Entries are sorted by name. */
#ifndef _DIRENT_H
#define _DIRENT_H

#include <sys/types.h>

typedef struct __crs_folder DIR;

#define DT_UNKNOWN 0
#define DT_DIR 4
#define DT_REG 8

struct dirent {
    ino_t d_ino;
    off_t d_off;
    unsigned short d_reclen;
    unsigned char d_type;
    char d_name[256];
};

DIR *opendir(const char *name);
struct dirent *readdir(DIR *folder);
void rewinddir(DIR *folder);
long telldir(DIR *folder);
void seekdir(DIR *folder, long place);
int closedir(DIR *folder);
int scandir(const char *name, struct dirent ***entries, int (*wanted)(const struct dirent *),
            int (*compare)(const struct dirent **, const struct dirent **));
int alphasort(const struct dirent **left, const struct dirent **right);

#endif
