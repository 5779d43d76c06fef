/* A struct without its semicolon, before `main`. */
struct p { int x; } // error: expected ';' after '}'
//                 ^
int main(void)
{
    return 0;
}
