/* Folders and links (POSIX unistd.h). The disk of a run has names with slashes in them, no folders
   that could be entered. */
#include <errno.h>
#include <string.h>
#include <unistd.h>

#include <crs/refuse.h>

UNAVAILABLE(int, chdir, (const char *name), -1, EACCES)
UNAVAILABLE(int, link, (const char *from, const char *to), -1, EPERM)
UNAVAILABLE(int, symlink, (const char *from, const char *to), -1, EPERM)

/* No name is a link. */
ssize_t readlink(const char *name, char *text, size_t size)
{
    (void)text;
    (void)size;
    (void)name;
    errno = EINVAL;
    return -1;
}

char *getcwd(char *text, size_t size)
{
    if (text == NULL || size < 2) {
        errno = text == NULL ? EINVAL : ERANGE;
        return NULL;
    }
    strcpy(text, "/");
    return text;
}
