/* Descriptors: the standard streams and open files by small numbers. The host stores the contents
   of files; the file positions are kept here. */
#include <crs_request.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

#include <crs/clock.h>
#include <crs/descriptor.h>
#include <crs/write.h>

static struct __crs_open_file standard_files[3] = {
    {1, O_RDONLY, -1, 0, NULL}, {1, O_WRONLY, -1, 1, NULL}, {1, O_WRONLY, -1, 2, NULL},
};
static struct __crs_open_file open_files[CRS_DESCRIPTORS];
static struct __crs_open_file *table[CRS_DESCRIPTORS] = {
    standard_files, standard_files + 1, standard_files + 2,
};

static int fail(int number)
{
    errno = number;
    return -1;
}

struct __crs_open_file *__crs_find(int descriptor)
{
    if (descriptor >= 0 && descriptor < CRS_DESCRIPTORS && table[descriptor] != NULL)
        return table[descriptor];
    errno = EBADF;
    return NULL;
}

/* Posts a request about a file; returns the reply's result, -1 with errno on error. */
static int ask(int code, struct __crs_message *message)
{
    int result = __crs_request(code, message);

    return result < 0 ? fail(-result) : result;
}

int __crs_by_name(int code, const char *name, int argument)
{
    struct __crs_message message;
    size_t size = strlen(name);

    if (size > CRS_DATA_SIZE)
        return fail(ENAMETOOLONG);
    message.i[0] = argument;
    message.i[1] = message.i[2] = 0;
    message.size = size;
    __builtin_memcpy(message.data, name, size);
    return ask(code, &message);
}

/* Finds a free descriptor from `wanted` on; returns -1 if there is none. */
static int free_descriptor(int wanted)
{
    for (; wanted < CRS_DESCRIPTORS; wanted++)
        if (table[wanted] == NULL)
            return wanted;
    return fail(EMFILE);
}

int __crs_install(const struct __crs_operations *operations, int number, int flags)
{
    int descriptor = free_descriptor(0), i;

    if (descriptor < 0)
        return -1;
    for (i = 0; open_files[i].uses > 0; i++)
        ;
    open_files[i].uses = 1;
    open_files[i].flags = flags;
    open_files[i].number = number;
    open_files[i].offset = 0;
    open_files[i].operations = operations;
    table[descriptor] = &open_files[i];
    return descriptor;
}

int __crs_open(const char *name, int flags)
{
    int number;

    if (free_descriptor(0) < 0)
        return -1;
    number = __crs_by_name(CRS_FILE_OPEN, name, flags);
    return number < 0 ? -1 : __crs_install(NULL, number, flags);
}

int __crs_close(int descriptor)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    struct __crs_message message;

    if (file == NULL)
        return -1;
    table[descriptor] = NULL;
    if (--file->uses > 0 || file->number < 0)
        return 0;
    if (file->operations != NULL)
        return file->operations->close(file);
    message.i[0] = file->number;
    message.i[1] = message.i[2] = message.size = 0;
    return ask(CRS_FILE_CLOSE, &message);
}

int __crs_duplicate(int descriptor, int wanted)
{
    struct __crs_open_file *file = __crs_find(descriptor);

    if (file == NULL)
        return -1;
    if (wanted < 0 || wanted >= CRS_DESCRIPTORS)
        return fail(EINVAL);
    wanted = free_descriptor(wanted);
    if (wanted >= 0) {
        table[wanted] = file;
        file->uses++;
    }
    return wanted;
}

long __crs_resize(int descriptor, long size)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    struct __crs_message message;

    if (file == NULL)
        return -1;
    if (file->number < 0 || file->operations != NULL
        || (size >= 0 && (file->flags & O_ACCMODE) == O_RDONLY))
        return fail(EINVAL);
    message.i[0] = file->number;
    message.i[1] = size;
    message.i[2] = message.size = 0;
    return ask(CRS_FILE_RESIZE, &message);
}

/* The standard streams cannot be positioned, as if they were a terminal or a pipe. */
long __crs_seek(int descriptor, long offset, int whence)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    long long place = offset;

    if (file == NULL)
        return -1;
    if (file->number < 0 || file->operations != NULL)
        return fail(ESPIPE);
    if (whence == SEEK_CUR)
        place += file->offset;
    else if (whence == SEEK_END)
        place += __crs_resize(descriptor, -1);
    else if (whence != SEEK_SET)
        return fail(EINVAL);
    if (place < 0 || place > 0x7fffffff)
        return fail(place < 0 ? EINVAL : EOVERFLOW);
    return file->offset = place;
}

int __crs_input(double *wait_s)
{
    struct __crs_message message;
    int ready = __crs_request(CRS_INPUT, &message);

    *wait_s = message.f[0];
    return ready;
}

/* Lets the time pass until somebody has typed something; signals do not end the wait. */
static void wait_for_input(void)
{
    double wait_s;

    while (__crs_input(&wait_s), wait_s > 0 && wait_s < __builtin_inf())
        __crs_pass(wait_s);
}

int __crs_read(int descriptor, void *bytes, int size)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    struct __crs_message message;

    if (file == NULL)
        return -1;
    if ((file->flags & O_ACCMODE) == O_WRONLY)
        return fail(EBADF);
    if (file->operations != NULL)
        return file->operations->read(file, bytes, size);
    if (size > CRS_DATA_SIZE)
        size = CRS_DATA_SIZE;
    message.size = 0;
    if (file->number < 0) {
        wait_for_input();
        message.i[0] = file->offset;
        message.i[1] = size;
        message.i[2] = 0;
        size = __crs_request(CRS_READ, &message);
    } else {
        message.i[0] = file->number;
        message.i[1] = file->offset;
        message.i[2] = size;
        size = __crs_request(CRS_FILE_READ, &message);
    }
    if (size < 0 || size > CRS_DATA_SIZE)
        return fail(EIO);
    __builtin_memcpy(bytes, message.data, size);
    if (file->number >= 0)
        file->offset += size;
    return size;
}

int __crs_put(int descriptor, const void *bytes, int size)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    struct __crs_message message;
    const char *from = bytes;
    int end;

    if (file == NULL)
        return -1;
    if ((file->flags & O_ACCMODE) == O_RDONLY)
        return fail(EBADF);
    if (file->operations != NULL)
        return file->operations->write(file, bytes, size) < 0 ? -1 : 0;
    if (file->number < 0)
        return __crs_write(file->offset, bytes, size);
    while (size > 0) {
        message.i[0] = file->number;
        message.i[1] = file->flags & O_APPEND ? -1 : file->offset;
        message.i[2] = 0;
        message.size = size < CRS_DATA_SIZE ? size : CRS_DATA_SIZE;
        __builtin_memcpy(message.data, from, message.size);
        from += message.size;
        size -= message.size;
        end = ask(CRS_FILE_WRITE, &message);
        if (end < 0)
            return -1;
        file->offset = end;
    }
    return 0;
}
