/* Streams in memory: fmemopen in all modes, open_memstream. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void show(const char *title, const char *bytes, int size) {
    printf("%s:", title);
    for (int i = 0; i < size; i++) printf(bytes[i] ? " %c" : " 0", bytes[i]);
    putchar('\n');
}

static void reading(void) {
    char text[] = "speed 12 turn 3.5\nsecond line", line[40], word[10];
    int number;
    double turn;
    FILE *in = fmemopen(text, strlen(text), "r");
    printf("%d", fscanf(in, "%9s %d %*s %lf", word, &number, &turn));
    printf(" %s %d %g\n", word, number, turn);
    printf("%s", fgets(line, sizeof line, in));
    printf("%s|%ld\n", fgets(line, sizeof line, in), ftell(in));
    printf("%d %d\n", getc(in), feof(in));
    printf("%d %c\n", fseek(in, -4, SEEK_END), getc(in));
    printf("%d %d\n", fseek(in, 100, SEEK_SET), fseek(in, -1, SEEK_SET));
    printf("%d %d\n", fputs("x", in) == EOF, ferror(in) != 0);
    rewind(in);
    printf("%c%c\n", getc(in), ungetc('z', in));
    fclose(in);
    in = fmemopen(text, sizeof text, "r");
    printf("%d\n", (int) fread(line, 1, sizeof line, in));
    fclose(in);
}

static void writing(void) {
    char small[8], large[16];
    memset(small, '-', sizeof small);
    FILE *out = fmemopen(small, sizeof small, "w");
    fprintf(out, "%d", 123);
    fflush(out);
    show("w", small, sizeof small);
    fputs("4567890", out);
    printf("%d\n", fflush(out));
    show("full", small, sizeof small);
    fclose(out);
    strcpy(large, "abc");
    out = fmemopen(large, sizeof large, "a");
    fputs("de", out);
    fclose(out);
    puts(large);
    out = fmemopen(large, sizeof large, "r+");
    fputs("XY", out);
    fseek(out, 1, SEEK_CUR);
    printf("%c\n", getc(out));
    fclose(out);
    puts(large);
    out = fmemopen(large, sizeof large, "w+");
    printf("%d\n", large[0]);
    fputs("one two", out);
    rewind(out);
    char word[8];
    printf("%d %s\n", fscanf(out, "%*s %7s", word), word);
    fclose(out);
    out = fmemopen(NULL, 10, "w+");
    fputs("own", out);
    fseek(out, 1, SEEK_SET);
    printf("%c\n", getc(out));
    fclose(out);
    printf("%d\n", fmemopen(large, 5, "q") == NULL);
}

static void growing(void) {
    char *text = NULL;
    size_t size = 77;
    FILE *out = open_memstream(&text, &size);
    fflush(out);
    printf("[%s] %u\n", text, (unsigned) size);
    for (int i = 0; i < 300; i++) fprintf(out, "%d,", i);
    fflush(out);
    printf("%u %s\n", (unsigned) size, text + size - 12);
    printf("%ld\n", ftell(out));
    fseek(out, 2, SEEK_SET);
    fputs("!", out);
    fflush(out);
    printf("%u %c%c\n", (unsigned) size, text[2], text[0]);
    fclose(out);
    printf("%u\n", (unsigned) strlen(text));
    free(text);
    out = open_memstream(&text, &size);
    fseek(out, 3, SEEK_SET);
    putc('x', out);
    fclose(out);
    show("gap", text, size + 1);
    free(text);
}

int main(void) {
    reading();
    writing();
    growing();
    return 0;
}
