/* File status without opening files (POSIX sys/stat.h, access). Every file can be read
   and written; a directory exists as soon as a file is in it. */
#include <crs_request.h>
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utime.h>

#include <crs/descriptor.h>

#define START 946684800L   /* of every run: 1 January 2000, 00:00:00 UTC, in Unix time */

static int describe(struct stat *found, int number, mode_t mode, off_t size)
{
    __builtin_memset(found, 0, sizeof *found);
    found->st_ino = number + 2;
    found->st_mode = mode;
    found->st_nlink = 1;
    found->st_size = size;
    found->st_blksize = 4096;
    found->st_blocks = (size + 511) / 512;
    found->st_atime = found->st_mtime = found->st_ctime = START;
    return 0;
}

static int describe_open(int descriptor, struct stat *found)
{
    struct __crs_open_file *file = __crs_find(descriptor);

    if (file == NULL)
        return -1;
    if (file->operations != NULL)
        return describe(found, file->number, S_IFSOCK | 0777, 0);
    if (file->number < 0)
        return describe(found, 0, S_IFIFO | 0600, 0);
    return describe(found, file->number, S_IFREG | 0644, __crs_resize(descriptor, -1));
}

static int describe_name(const char *name, struct stat *found)
{
    int descriptor = __crs_open(name, O_RDONLY), result;

    if (descriptor < 0)
        return errno == EISDIR ? describe(found, 0, S_IFDIR | 0755, 4096) : -1;
    result = describe_open(descriptor, found);
    __crs_close(descriptor);
    return result;
}

int fstat(int descriptor, struct stat *found)
{
    return describe_open(descriptor, found);
}

int stat(const char *name, struct stat *found)
{
    return describe_name(name, found);
}

int lstat(const char *name, struct stat *found)
{
    return describe_name(name, found);
}

int access(const char *name, int mode)
{
    struct stat found;

    if (describe_name(name, &found) < 0)
        return -1;
    if (mode & X_OK && !S_ISDIR(found.st_mode)) {
        errno = EACCES;
        return -1;
    }
    return 0;
}

/* A folder needs no making; nothing remembers one in which no file is. */
int mkdir(const char *name, mode_t mode)
{
    struct stat found;

    (void)mode;
    if (describe_name(name, &found) == 0) {
        errno = EEXIST;
        return -1;
    }
    return errno == ENOENT && *name ? 0 : -1;
}

int rmdir(const char *name)
{
    struct stat found;

    if (describe_name(name, &found) < 0)
        return -1;
    errno = S_ISDIR(found.st_mode) ? ENOTEMPTY : ENOTDIR;
    return -1;
}

static int exists(const char *name)
{
    struct stat found;

    return describe_name(name, &found);
}

int chmod(const char *name, mode_t mode)
{
    (void)mode;
    return exists(name);
}

int fchmod(int descriptor, mode_t mode)
{
    (void)mode;
    return __crs_find(descriptor) == NULL ? -1 : 0;
}

int chown(const char *name, uid_t owner, gid_t group)
{
    (void)owner;
    (void)group;
    return exists(name);
}

mode_t umask(mode_t mask)
{
    static mode_t current = 022;
    mode_t before = current;

    current = mask & 0777;
    return before;
}

int utime(const char *name, const struct utimbuf *times)
{
    (void)times;
    return exists(name);
}

int flock(int descriptor, int operation)
{
    (void)operation;
    return __crs_find(descriptor) == NULL ? -1 : 0;
}
