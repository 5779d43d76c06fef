/* File modes, contents and positions. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void show(const char *name)
{
    FILE *file = fopen(name, "r");
    int c, count = 0;

    if (file == NULL) {
        printf("%s: %s\n", name, strerror(errno));
        return;
    }
    printf("%s:", name);
    while ((c = getc(file)) != EOF)
        if (count++ < 60)
            printf(c < ' ' ? "\\%o" : "%c", c);
    printf(" (%d, at %ld, end %d)\n", count, ftell(file), feof(file) != 0);
    fclose(file);
}

static void streams(void)
{
    FILE *file = fopen("a.txt", "w");
    char line[40];
    fpos_t place;
    int i;

    for (i = 0; i < 400; i++)
        fprintf(file, "line %d\n", i);
    printf("%ld\n", ftell(file));
    printf("%d %d\n", getc(file), ferror(file) != 0);
    fclose(file);
    show("a.txt");
    file = fopen("a.txt", "r+");
    fgets(line, sizeof line, file);
    fgetpos(file, &place);
    printf("%s%ld\n", line, ftell(file));
    fseek(file, 0, SEEK_CUR);
    fputs("LINE", file);
    fseek(file, -7, SEEK_END);
    fgets(line, sizeof line, file);
    printf("%s", line);
    fsetpos(file, &place);
    printf("%d", ungetc('<', file));
    printf(" %ld %s", ftell(file), fgets(line, sizeof line, file));
    rewind(file);
    printf("%d %d\n", fscanf(file, "line %d", &i), i);
    fclose(file);
    file = fopen("a.txt", "a+");
    fputs("end\n", file);
    printf("%ld\n", ftell(file));
    fseek(file, 0, SEEK_SET);
    fputs("more\n", file);
    fseek(file, -9, SEEK_END);
    printf("%d", (int)fread(line, 1, 9, file));
    printf(" %.9s", line);
    fclose(file);
    file = fopen("a.txt", "w+x");
    printf("%d %d\n", file == NULL, errno == EEXIST);
}

static void descriptors(void)
{
    int file = open("b.bin", O_RDWR | O_CREAT | O_TRUNC, 0644), copy;
    struct stat found;
    char bytes[12];

    printf("%d", (int)write(file, "0123456789", 10));
    printf(" %d", (int)lseek(file, 20, SEEK_SET));
    printf(" %d\n", (int)write(file, "x", 1));
    fstat(file, &found);
    printf("%d %d\n", (int)found.st_size, S_ISREG(found.st_mode));
    copy = dup(file);
    printf("%d", (int)lseek(copy, 5, SEEK_SET));
    printf(" %d %.4s\n", (int)read(file, bytes, 4), bytes);
    printf("%d", (int)pread(file, bytes, 3, 7));
    printf(" %.3s %d\n", bytes, (int)lseek(file, 0, SEEK_CUR));
    ftruncate(file, 4);
    printf("%d %d\n", (int)lseek(file, 0, SEEK_END), (int)read(file, bytes, 4));
    close(file);
    close(copy);
    printf("%d %d\n", (int)read(file, bytes, 1), errno == EBADF);
    printf("%d %d %d\n", access("b.bin", R_OK | W_OK), access("none", F_OK), errno == ENOENT);
    show("b.bin");
}

static void names(void)
{
    FILE *file;

    printf("%d %d\n", rename("b.bin", "c.bin"), rename("b.bin", "d"));
    show("b.bin");
    show("c.bin");
    printf("%d %d\n", remove("c.bin"), unlink("c.bin"));
    file = tmpfile();
    fputs("temporary", file);
    rewind(file);
    printf("%c\n", getc(file));
    fclose(file);
    printf("%d %s\n", fopen("a.txt/b", "w") == NULL, strerror(errno));
}

static void standard_streams(void)
{
    int saved;

    fflush(stdout);
    saved = dup(1);
    freopen("out.txt", "w", stdout);
    printf("to the file\n");
    fflush(stdout);
    dup2(saved, 1);
    printf("back again\n");
    show("out.txt");
    remove("out.txt");
    remove("a.txt");
}

int main(void)
{
    streams();
    descriptors();
    names();
    standard_streams();
    return 0;
}
