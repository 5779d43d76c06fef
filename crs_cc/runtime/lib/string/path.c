/* Parts of a path (POSIX libgen.h; the first basename is GNU's, which changes nothing). */
#include <string.h>

char *basename(const char *path)
{
    const char *slash = strrchr(path, '/');

    return (char *)(slash == NULL ? path : slash + 1);
}

/* Removes trailing slashes; returns the remaining length, 0 for nothing but slashes. */
static size_t trim(char *path)
{
    size_t length = strlen(path);

    while (length > 0 && path[length - 1] == '/')
        length--;
    return length;
}

char *__xpg_basename(char *path)
{
    size_t length;
    char *slash;

    if (path == NULL || *path == 0)
        return ".";
    length = trim(path);
    if (length == 0)
        return "/";
    path[length] = 0;
    slash = strrchr(path, '/');
    return slash == NULL ? path : slash + 1;
}

char *dirname(char *path)
{
    size_t length;

    if (path == NULL || *path == 0)
        return ".";
    length = trim(path);
    if (length == 0)
        return "/";
    while (length > 0 && path[length - 1] != '/')
        length--;
    if (length == 0)
        return ".";
    path[length] = 0;
    length = trim(path);
    if (length == 0)
        return "/";
    path[length] = 0;
    return path;
}
