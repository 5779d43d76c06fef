/* One #else belongs to an #if, and nothing after it. */
#if 0
int a;
#else
int b;
#else // error: #else
int c;
#endif

int main(void)
{
    return 0;
}
