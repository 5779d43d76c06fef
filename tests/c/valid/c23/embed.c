/* #embed: the bytes of a file as a list of numbers. */
// without gcc: gcc 12 has no #embed
#include <stdio.h>
static const unsigned char d[] = {
#embed "letters.txt"
};
static const unsigned char l[] = {
#embed "letters.txt" limit(3) suffix(, 0)
};
#if __has_embed("letters.txt") == __STDC_EMBED_FOUND__
#define OK 1
#endif
int main(void) {
    printf("%d %d %d %d\n", (int) sizeof d, d[0], (int) sizeof l, OK);
    return 0;
}
