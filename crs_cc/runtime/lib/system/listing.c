/* Listing folders (POSIX dirent.h). */
#include <crs_request.h>
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <crs/folder.h>

struct __crs_folder {
    long at;                /* entries read so far, of which . and .. are the first */
    struct dirent entry;
    char name[];
};

/* Reads the entry with a number, . and .. not counted; returns its length, 0 at the end. */
static int read_entry(const char *folder, int number, struct dirent *entry)
{
    struct __crs_message message;
    int size;

    message.i[0] = number;
    message.i[1] = message.i[2] = 0;
    message.size = strlen(folder);
    __builtin_memcpy(message.data, folder, message.size);
    size = __crs_request(CRS_FILE_LIST, &message);
    if (size < 0) {
        errno = -size;
        return -1;
    }
    entry->d_type = size > 0 && message.data[size - 1] == '/' ? DT_DIR : DT_REG;
    __builtin_memcpy(entry->d_name, message.data, size);
    entry->d_name[size - (entry->d_type == DT_DIR)] = 0;
    return size;
}

DIR *__crs_open_folder(const char *name)
{
    size_t size = strlen(name) + 1;
    DIR *folder;
    struct dirent first;

    if (size > CRS_DATA_SIZE || size == 1) {
        errno = size == 1 ? ENOENT : ENAMETOOLONG;
        return NULL;
    }
    if (read_entry(name, 0, &first) < 0)
        return NULL;
    folder = calloc(1, sizeof *folder + size);
    if (folder != NULL)
        __builtin_memcpy(folder->name, name, size);
    return folder;
}

struct dirent *__crs_read_folder(DIR *folder)
{
    struct dirent *entry = &folder->entry;

    if (folder->at < 2) {
        strcpy(entry->d_name, folder->at == 0 ? "." : "..");
        entry->d_type = DT_DIR;
    } else if (read_entry(folder->name, folder->at - 2, entry) <= 0) {
        return NULL;
    }
    entry->d_off = ++folder->at;
    entry->d_ino = folder->at;
    entry->d_reclen = sizeof *entry;
    return entry;
}

void rewinddir(DIR *folder)
{
    folder->at = 0;
}

long telldir(DIR *folder)
{
    return folder->at;
}

void seekdir(DIR *folder, long place)
{
    folder->at = place;
}

void __crs_close_folder(DIR *folder)
{
    free(folder);
}

DIR *opendir(const char *name)
{
    return __crs_open_folder(name);
}

struct dirent *readdir(DIR *folder)
{
    return __crs_read_folder(folder);
}

int closedir(DIR *folder)
{
    free(folder);
    return 0;
}

int alphasort(const struct dirent **left, const struct dirent **right)
{
    return strcmp((*left)->d_name, (*right)->d_name);
}

static int discard(struct dirent **found, int count, DIR *folder)
{
    while (count > 0)
        free(found[--count]);
    free(found);
    __crs_close_folder(folder);
    errno = ENOMEM;
    return -1;
}

int scandir(const char *name, struct dirent ***entries, int (*wanted)(const struct dirent *),
            int (*compare)(const struct dirent **, const struct dirent **))
{
    DIR *folder = __crs_open_folder(name);
    struct dirent **found = NULL, **larger, *entry;
    int count = 0;

    if (folder == NULL)
        return -1;
    while ((entry = __crs_read_folder(folder)) != NULL) {
        if (wanted != NULL && !wanted(entry))
            continue;
        larger = realloc(found, (count + 1) * sizeof *found);
        if (larger == NULL)
            return discard(found, count, folder);
        found = larger;
        found[count] = malloc(sizeof *entry);
        if (found[count] == NULL)
            return discard(found, count, folder);
        *found[count++] = *entry;
    }
    __crs_close_folder(folder);
    if (compare != NULL && count > 0)
        qsort(found, count, sizeof *found, (int (*)(const void *, const void *))compare);
    *entries = found;
    return count;
}
