/* An #endif without its #if. */
int main(void)
{
    return 0;
}
#endif // error: #endif
