/* Wide characters and UTF-8. */
#define _GNU_SOURCE
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>
#include <wctype.h>

static void conversions(void)
{
    static const char *const texts[] = {
        "plain", "caf\303\251", "\342\202\254 5", "\360\237\244\226", "bad \377", "cut \342\202",
        "\300\200", "\355\240\200",
    };
    wchar_t wide[16];
    char back[32];
    size_t i, count, k;

    for (i = 0; i < sizeof texts / sizeof *texts; i++) {
        count = mbstowcs(wide, texts[i], 16);
        printf("%d:", (int)count);
        for (k = 0; (int)count > 0 && k < count; k++)
            printf(" %x", (unsigned int)wide[k]);
        if ((int)count >= 0)
            printf(" %d", (int)wcstombs(back, wide, sizeof back));
        printf(" %d\n", (int)count >= 0 && strcmp(back, texts[i]) == 0);
    }
    printf("%d %d %d\n", (int)mbstowcs(NULL, "caf\303\251", 0), mblen("\303\251", 2),
           mblen("\303", 1));
    printf("%d ", wctomb(back, 0x20ac));
    printf("%d\n", (int)wcstombs(back, L"x\x20acy", 3));
}

static void pieces(void)
{
    static const char bytes[] = "a\342\202\254b";
    mbstate_t state;
    const char *at = bytes;
    wchar_t c, wide[8];
    size_t i;

    memset(&state, 0, sizeof state);
    for (i = 0; i < sizeof bytes; i++) {
        size_t result = mbrtowc(&c, bytes + i, 1, &state);
        printf("%d,%d ", (int)result, mbsinit(&state) != 0);
    }
    printf("%d", (int)mbsrtowcs(wide, &at, 8, &state));
    printf(" %d\n", at == NULL);
}

int main(void)
{
    wchar_t text[32], *rest, *end;

    setlocale(LC_ALL, "C.UTF-8");
    conversions();
    pieces();
    wcscpy(text, L"one two");
    wcscat(text, L" three");
    wcsncat(text, L" four", 2);
    printf("%d %ls|\n", (int)wcslen(text), text);
    printf("%d %d %d\n", wcscmp(L"a", L"b") < 0, wcsncmp(L"abc", L"abd", 2),
           wmemcmp(L"ab", L"ac", 2) < 0);
    printf("%ls %ls %ls\n", wcschr(text, L't'), wcsrchr(text, L't'), wcsstr(text, L"two"));
    printf("%d %d %ls\n", (int)wcsspn(text, L"neo"), (int)wcscspn(text, L" "),
           wcspbrk(text, L"wx"));
    for (end = wcstok(text, L" ", &rest); end != NULL; end = wcstok(NULL, L" ", &rest))
        printf("<%ls>", end);
    printf("\n%ld %g %lld\n", wcstol(L" -0x1fz", &end, 0), wcstod(L"2.5e3x", NULL),
           wcstoll(L"99999999999", NULL, 10));
    printf("%ls\n", end);
    printf("%d %d %d %d %d\n", iswalpha(L'a') != 0, iswdigit(L'a'), iswspace(L' ') != 0,
           towupper(L'q'), iswctype(L'7', wctype("digit")) != 0);
    printf("%d", swprintf(text, 32, L"%d %ls %s %.2f", 7, L"wide", "narrow", 1.5));
    printf(" %ls\n", text);
    printf("%d\n", swprintf(text, 3, L"%d", 12345));
    printf("%d", sscanf("caf\303\251 \342\202\254x \303\251\303\251", "%ls %2ls %lc%lc", text, text + 10,
                        text + 20, text + 21));
    printf(" %ls %ls %x %x\n", text, text + 10, (unsigned int)text[20], (unsigned int)text[21]);
    printf("%5ls|%-5ls|%.4ls|%lc\n", L"\x20ac", L"\xe9", L"\x20ac\x20ac", (wint_t)0xe9);
    return 0;
}
