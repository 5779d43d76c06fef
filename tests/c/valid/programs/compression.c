/* LZ77 with a small window, run lengths, and their way back. */
#include <stdio.h>
#include <string.h>

static int lz_pack(const char *in, int n, unsigned char *out)
{
    int at = 0, size = 0;

    while (at < n) {
        int best = 0, from = 0, start = at > 63 ? at - 63 : 0, j;
        for (j = start; j < at; j++) {
            int k = 0;
            while (k < 15 && at + k < n - 1 && in[j + k] == in[at + k])
                k++;
            if (k > best)
                best = k, from = at - j;
        }
        out[size++] = from;
        out[size++] = best;
        out[size++] = in[at + best];
        at += best + 1;
    }
    return size;
}

static int lz_unpack(const unsigned char *in, int size, char *out)
{
    char *start = out;
    const unsigned char *end = in + size;

    for (; in < end; in += 3) {
        int n = in[1];
        const char *from = out - in[0];
        while (n--)
            *out++ = *from++;
        *out++ = in[2];
    }
    return out - start;
}

static char *rle(const char *s, char *to)
{
    char *start = to;

    while (*s) {
        int n = 1;
        while (s[n] == *s)
            n++;
        to += n > 1 ? sprintf(to, "%d%c", n, *s) : sprintf(to, "%c", *s);
        s += n;
    }
    return start;
}

int main(void)
{
    const char *texts[] = { "abcabcabcabcabcd", "the robot turned and the robot turned again",
                            "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaa!", "x" };
    unsigned char packed[200];
    char back[100], runs[100];
    int i, j, size, n;

    for (i = 0; i < 4; i++) {
        size = lz_pack(texts[i], strlen(texts[i]), packed);
        n = lz_unpack(packed, size, back);
        back[n] = 0;
        printf("%d -> %d %d:", (int) strlen(texts[i]), size, strcmp(back, texts[i]) == 0);
        for (j = 0; j < size && j < 12; j += 3)
            printf(" (%d,%d,%c)", packed[j], packed[j + 1], packed[j + 2]);
        printf("\n");
    }
    printf("%s\n", rle("aaabccddddddddddddeff", runs));
    return 0;
}
